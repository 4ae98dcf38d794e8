#include "hsr/painter/verify/verify.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>

#include "geometry/error.h"
#include "hsr/cli/command_context.h"
#include "hsr/cli/commands.h"
#include "hsr/cli/output_summary.h"
#include "hsr/cli/scene_arguments.h"
#include "hsr/io/read/read.h"
#include "hsr/io/write/format.h"
#include "hsr/io/write/verdict_svg.h"

namespace hsr::cli {

using namespace internal;

namespace {

struct VerifyArguments {
  ModelArguments models;
  std::string output;
  ViewOptions view;
  SceneArguments scene;
  std::uint64_t limit = 10;
  CommonArguments common;
};

const char* const examples = R"(Examples:
  hsr verify order.json                            the view is the file's
  hsr verify scene.obj --view top                  is the order of its faces right for that view?
  hsr verify order.json --limit 100 -o wrong.svg   with a picture: painted earlier blue, later red, a ring where they are wrong

Writes the verdict to standard output, and a picture or a report if asked. Exit status 1: the order is wrong.
The faces of a model are verified with the sections given here, an order in a file with all that it was made with.)";

bool is_json(const std::string& path) { return path.size() > 5 && path.ends_with(".json"); }

/// The file that holds an order; nothing: models whose faces are painted as they come.
std::optional<std::string> order_file(const ModelArguments& a) {
  const bool is_any = std::any_of(a.models.begin(), a.models.end(), is_json) || a.from == "json";
  if (!is_any) return {};
  if (a.models.size() > 1) throw InputError("verify: found an order beside another file, expected one order, or models");
  return a.models.front() == "-" ? "/dev/stdin" : a.models.front();
}

bool asks_for_view(const ViewOptions& v) { return !v.name.empty() || !v.eye.empty() || !v.direction.empty(); }

bool changes_view(const ViewOptions& v) { return !v.target.empty() || !v.up.empty() || v.near || v.field_of_view; }

std::string point_text(const std::array<Rational, 3>& p) {
  return fmt::format("{:.9g},{:.9g},{:.9g}", p[0].to_double(), p[1].to_double(), p[2].to_double());
}

class Teller {
 public:
  Teller(const Verdict& verdict, const std::vector<PaintedPolygon>& pieces, Coplanar coplanar)
      : verdict_(verdict), pieces_(pieces), coplanar_(coplanar) {}

  void say() const {
    fmt::print("{}\n", summary());
    for (const Violation& v : verdict_.first) fmt::print("{}\n", line(v));
    const std::uint64_t all = verdict_.wrong + verdict_.covered_twice;
    if (all > verdict_.first.size()) fmt::print("and {} more: --limit shows them\n", all - verdict_.first.size());
    if (!verdict_.order_exists) fmt::print("{}\n", cycle());
    if (!verdict_.order_exists && verdict_.cuts_that_suffice)
      fmt::print("{} cuts along the planes of these faces suffice; 'hsr order' finds fewer\n", *verdict_.cuts_that_suffice);
  }

  Report::Json json() const {
    Report::Json violations = Report::Json::array();
    for (const Violation& v : verdict_.first)
      violations.push_back({{"pieces", Report::Json::array({v.earlier, v.later})},
                            {"faces", Report::Json::array({face(v.earlier), face(v.later)})},
                            {"kind", kind(v.fault)},
                            {"witness", witness(v.witness)}});
    Report::Json cycle = Report::Json::array();
    for (std::size_t k = 0; k < verdict_.cycle.size(); ++k)
      cycle.push_back(
          {{"piece", verdict_.cycle[k]}, {"face", face(verdict_.cycle[k])}, {"witness", witness(verdict_.cycle_witnesses[k])}});
    Report::Json out = {{"correct", verdict_.is_correct()},
                        {"pieces", verdict_.polygons},
                        {"wires", verdict_.wires},
                        {"triangulated", verdict_.triangulated},
                        {"overlapping", verdict_.overlapping},
                        {"wrong", verdict_.wrong},
                        {"piercing", verdict_.piercing},
                        {"order_exists", verdict_.order_exists},
                        {"violations", std::move(violations)},
                        {"cycle", std::move(cycle)}};
    if (verdict_.cuts_that_suffice) out.set("cuts_that_suffice", *verdict_.cuts_that_suffice);
    return out;
  }

 private:
  std::string summary() const {
    const std::string judged =
        verdict_.triangulated == 0
            ? std::string()
            : fmt::format(" ({} that are not planar or not convex, by their triangles)", verdict_.triangulated);
    std::string pieces = counted(verdict_.polygons, "piece") + judged;
    if (verdict_.wires > 0) pieces += " and " + counted(verdict_.wires, "part") + " of wires";
    if (verdict_.is_correct())
      return fmt::format("correct: {}, each of {} overlapping pairs is painted far to near", pieces, verdict_.overlapping);
    std::string wrong = fmt::format("{} of {} overlapping pairs of {} are painted the wrong way round", verdict_.wrong,
                                    verdict_.overlapping, pieces);
    if (verdict_.piercing > 0) wrong += fmt::format(", {} of them pierce each other", verdict_.piercing);
    if (verdict_.covered_twice > 0)
      wrong += fmt::format("; {} pairs of pieces of one face cover a place twice", verdict_.covered_twice);
    if (!verdict_.order_exists) return "no order of these faces can be correct: " + wrong;
    return "wrong: " + wrong + (verdict_.wrong > 0 ? "; another order of these pieces is right" : "");
  }
  std::string cycle() const {
    std::string text = "cycle:";
    for (std::size_t k = 0; k < verdict_.cycle.size(); ++k)
      text += fmt::format("{} {} must come before {} (at {})", k == 0 ? "" : ",", name(verdict_.cycle[k]),
                          name(verdict_.cycle[(k + 1) % verdict_.cycle.size()]),
                          point_text(verdict_.cycle_witnesses[k].of_earlier));
    return text;
  }
  std::string name(std::uint32_t piece) const {
    if (pieces_[piece].corners.size() == 2) return fmt::format("piece {} (of a wire)", piece);
    return pieces_[piece].face ? fmt::format("piece {} (face {})", piece, *pieces_[piece].face)
                               : fmt::format("piece {}", piece);
  }
  static const char* kind(Fault fault) {
    switch (fault) {
      case Fault::order:
        return "order";
      case Fault::piercing:
        return "piercing";
      case Fault::coplanar:
        return "coplanar";
      case Fault::covered_twice:
        return "covered twice";
    }
    return "";
  }
  std::string line(const Violation& v) const {
    const std::string where =
        fmt::format("at {:.9g}, {:.9g} of the image", v.witness.place[0].to_double(), v.witness.place[1].to_double());
    if (v.fault == Fault::covered_twice)
      return fmt::format("{} and {} cover a place of their face twice {}", name(v.earlier), name(v.later), where);
    if (v.fault == Fault::coplanar)
      return fmt::format("{} and {} lie in one plane, the {} face is painted last {}", name(v.earlier), name(v.later),
                         coplanar_ == Coplanar::first ? "higher" : "lower", where);
    return fmt::format("{} is painted before {}, but is the nearer {}{}: {} against {}", name(v.earlier), name(v.later), where,
                       v.fault == Fault::piercing ? " (they pierce each other)" : "", point_text(v.witness.of_earlier),
                       point_text(v.witness.of_later));
  }
  Report::Json face(std::uint32_t piece) const {
    return pieces_[piece].face ? Report::Json(*pieces_[piece].face) : Report::Json();
  }
  static Report::Json witness(const Witness& w) {
    const auto point = [](const auto& p) {
      Report::Json out = Report::Json::array();
      for (const Rational& x : p) out.push_back(x.to_double());
      return out;
    };
    return {{"image", point(w.place)}, {"earlier", point(w.of_earlier)}, {"later", point(w.of_later)}};
  }

  const Verdict& verdict_;
  const std::vector<PaintedPolygon>& pieces_;
  Coplanar coplanar_;
};

struct Input {
  std::vector<PaintedPolygon> pieces;
  View view;
  std::string title, name;
  std::optional<Coplanar> coplanar;  // if the file says so
};

/// The order of a model's faces.
Input from_model(const VerifyArguments& a, CommandContext& context) {
  const ViewedModel viewed = context.read(a.models, a.view);
  const Model& model = viewed.model;
  if (!viewed.chosen.note.empty()) context.note(viewed.chosen.note);
  Input in{{}, viewed.view(), viewed.chosen.title, viewed.name(), {}};
  for (std::size_t f = 0; f < model.polygons.size(); ++f) {
    PaintedPolygon p;
    p.face = static_cast<std::uint32_t>(f);
    for (const std::uint32_t v : model.polygons[f]) {
      const Point3& at = model.points[v];
      p.corners.push_back({at.x, at.y, at.z});
    }
    in.pieces.push_back(std::move(p));
  }
  return in;
}

Input from_order(const VerifyArguments& a, const std::string& path, CommandContext& context) {
  context.progress.stage("reading");
  PaintingFile file = context.report.timed("read", [&] { return read_order(path); });
  Input in{std::move(file.far_to_near), {}, "the file's", std::filesystem::path(path).filename().string(), file.coplanar};
  if (!asks_for_view(a.view) && file.view) {
    if (changes_view(a.view))
      throw InputError(
          "view: found --target, --up, --near or --fov alone, expected them with --view, --eye or --direction: the file has a "
          "view");
    in.view = *file.view;
    return in;
  }
  // Only for its centre, which a view may look at.
  std::vector<Point3> points;
  Polygons polygons;
  for (const PaintedPolygon& p : in.pieces) {
    const auto first = static_cast<std::uint32_t>(points.size());
    for (const auto& c : p.corners) points.push_back({c[0].to_double(), c[1].to_double(), c[2].to_double()});
    if (p.corners.size() == 2) {
      polygons.segments.push_back({first, first + 1});
      continue;
    }
    for (std::uint32_t k = first; k < points.size(); ++k) polygons.corners.push_back(k);
    polygons.first.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
  }
  const ChosenView chosen = choose_view(a.view, make_mesh(points, polygons), Model{});
  in.view = chosen.view;
  in.title = chosen.title;
  return in;
}

void run(const VerifyArguments& a, UnfinishedFiles& unfinished) {
  if (!a.output.empty()) (void)format_of(a.output, std::array{Format::svg});
  a.models.check();
  const std::optional<std::string> order = order_file(a.models);
  CommandContext context(a.common, a.models.models, {a.output}, unfinished);
  const Input in = order ? from_order(a, *order, context) : from_model(a, context);
  context.progress.stage("verify");
  VerifyOptions options;
  options.limit = a.limit;
  const Coplanar coplanar = !a.scene.asks_for_coplanar() && in.coplanar ? *in.coplanar : a.scene.which_coplanar();
  options.ties = coplanar;
  const Verdict verdict = context.report.timed("verify", [&] { return verify(in.pieces, in.view, options); });
  context.progress.clear();
  const Teller teller(verdict, in.pieces, coplanar);
  if (!context.is_quiet()) teller.say();
  if (!a.output.empty())
    context.write(a.output, verdict_svg(verdict, in.pieces, in.view, {in.name, "view: " + in.title}),
                  counted(verdict.first.size(), "violation"));
  context.report.set("verdict", teller.json());
  context.finish();
  if (!verdict.is_correct()) throw CheckFailed();
}

}  // namespace

void add_verify(CommandLine& command, UnfinishedFiles& unfinished) {
  auto a = std::make_shared<VerifyArguments>();
  Options options =
      command.add_verb("verify", "Is a painting order right for a view? The answer, and where it is not", examples);
  a->models.add_with_order_to(options);
  options.add("-o,--output", a->output, "FILE", "A picture of the violations, .svg");
  options.add("--limit", a->limit, "N", "Violations to describe").with_default_shown();
  a->view.add_to(options);
  a->scene.add_to(options);
  options.begin_group("Options");
  a->common.add_threads_to(options);
  a->common.add_report_to(options, "The verdict");
  a->common.add_quiet_to(options, "Only the exit status: 0 correct, 1 wrong");
  options.on_run([a, &unfinished] { run(*a, unfinished); });
}

}  // namespace hsr::cli
