#include "study/stability.h"

#include <fmt/format.h>

#include <memory>

#include "geometry/error.h"
#include "hsr/cli/command_context.h"
#include "hsr/cli/commands.h"
#include "hsr/cli/directory.h"
#include "hsr/cli/messages.h"
#include "study/stability_csv.h"
#include "study/stability_page.h"
#include "study/stability_plots.h"

namespace hsr::cli {

using namespace internal;

namespace {

struct StabilityArguments {
  std::string directory;
  std::vector<std::string> families;
  int size = 128;
  bool quick = false;
  CommonArguments common;
};

const char* const examples = R"(Examples:
  hsr stability -o stability                    all families, some minutes; open stability/index.html
  hsr stability -o stability --quick            fewer values, within a minute
  hsr stability -o gaps --family gap,distance   two families
  hsr stability -o soup --family soup --size 64

Writes index.html (needs nothing else), table.csv, report.json and plots/*.svg. Exit status 1: an exact method was wrong.)";

Report::Json json_of(const FamilyResult& f) {
  Report::Json values = Report::Json::array(), methods = Report::Json::array();
  for (const StabilityValue& v : f.values)
    values.push_back({{"value", v.value},
                      {"triangles", v.triangles},
                      {"covered", v.covered},
                      {"known", v.known},
                      {"caster_errors", v.caster_errors}});
  for (const StabilityRow& row : f.rows) {
    Report::Json outcomes = Report::Json::array(), wrong = Report::Json::array(), seconds = Report::Json::array();
    for (const StabilityPoint& p : row.points) {
      outcomes.push_back(name(p.outcome));
      wrong.push_back(p.wrong);
      seconds.push_back(p.seconds);
    }
    const auto number = [](const std::optional<double>& x) { return x ? Report::Json(*x) : Report::Json(); };
    methods.push_back({{"method", row.method},
                       {"numbers", row.numbers},
                       {"space", row.is_object_space ? "object" : "image"},
                       {"exact", row.is_exact},
                       {"breakdown", number(f.breakdown(row))},
                       {"predicted", number(row.predicted)},
                       {"outcomes", std::move(outcomes)},
                       {"wrong", std::move(wrong)},
                       {"seconds", std::move(seconds)}});
  }
  return {{"family", f.family.name},
          {"knob", f.family.knob},
          {"seconds", f.seconds},
          {"values", std::move(values)},
          {"methods", std::move(methods)}};
}

void describe(Report& report, const Stability& stability) {
  report.set("size", stability.size);
  report.set("quick", stability.quick);
  report.set("defects", stability.defects());
  Report::Json families = Report::Json::array();
  for (const FamilyResult& f : stability.families) {
    families.push_back(json_of(f));
    for (const StabilityRow& row : f.rows)
      for (std::size_t k = 0; k < row.points.size(); ++k)
        if (row.points[k].outcome == Outcome::left_out)
          report.leave_out(fmt::format("{}, {}, {} {}", f.family.name, row.name(), f.family.knob, f.values[k].value),
                           row.points[k].why);
  }
  report.set("families", std::move(families));
  Report::Json gaps = Report::Json::array(), biases = Report::Json::array();
  for (const MeasuredGap& g : stability.gaps)
    gaps.push_back({{"format", name(g.format)},
                    {"distance", g.distance},
                    {"near", g.near},
                    {"far", g.far},
                    {"predicted", g.predicted},
                    {"measured", g.measured}});
  for (const MeasuredBias& b : stability.biases)
    biases.push_back({{"format", name(b.format)},
                      {"bias", b.bias},
                      {"slope_bias", b.slope_bias},
                      {"shown_share", b.shown_share},
                      {"shines_through", b.shines_through}});
  report.set("gaps", std::move(gaps));
  report.set("biases", std::move(biases));
  report.set("machine", machine_and_date());
}

void run(const StabilityArguments& a, UnfinishedFiles& unfinished) {
  if (a.size < 16 || a.size > 1024)
    throw InputError(fmt::format("--size: found {}, expected 16 to 1024 samples each way", a.size));
  OutputDirectory directory(a.directory, unfinished);
  CommandContext context(a.common, {}, {}, unfinished);
  StabilityOptions options;
  options.families = a.families;
  options.size = a.size;
  options.quick = a.quick;
  options.progress = [&](const std::string& stage, double done) { context.progress.show(stage, done); };
  const Stability result = context.report.timed("stability", [&] { return stability(options); });

  context.progress.stage("writing");
  for (const NamedPlot& p : stability_plots(result)) directory.write("plots/" + p.name + ".svg", plot_file(p.plot));
  directory.write("table.csv", stability_csv(result));
  PageText text;
  text.title = "Where visibility methods break";
  text.facts = {
      fmt::format("{0} {1} of scenes with one knob each{2}; {3} x {3} samples", result.families.size(),
                  result.families.size() == 1 ? "family" : "families", a.quick ? ", fewer values (--quick)" : "", a.size),
      machine_and_date(), std::string("hsr ") + HSR_VERSION};
  directory.write("index.html", stability_page(result, text));
  describe(context.report, result);
  directory.write("report.json", context.report.text());
  context.say_written(directory, "index.html");

  // A wrong sample of an exact method is a defect of hsr, and never goes unsaid.
  const std::vector<std::string> defects = result.defects();
  for (const std::string& d : defects) tell("hsr: stability: {}: please report it\n", d);
  if (!defects.empty()) throw CheckFailed();
}

}  // namespace

void add_stability(CommandLine& command, UnfinishedFiles& unfinished) {
  auto a = std::make_shared<StabilityArguments>();
  Options options =
      command.add_verb("stability", "Stiff and extreme scenes: where each method and arithmetic breaks", examples);
  options.add("-o,--output", a->directory, "DIR", "The directory of the results; made if it is not there").required();
  std::vector<std::string> families;
  for (const StabilityFamily& f : stability_families()) families.push_back(f.name);
  options.add("--family", a->families, "NAME", fmt::format("Only these: {}", fmt::join(families, ", ")))
      .separated_by(',')
      .list_of(families);
  options.add("--size", a->size, "N", "Samples each way").with_default_shown();
  options.add_flag("--quick", a->quick, "Fewer values of each knob, within a minute");
  a->common.add_quiet_to(options, "Say nothing but what is wrong");
  options.on_run([a, &unfinished] { run(*a, unfinished); });
}

}  // namespace hsr::cli
