#include "study/stability_page.h"

#include <algorithm>

#include "hsr/io/write/image_png.h"
#include "hsr/model.h"
#include "study/page_texts.h"
#include "study/stability_csv.h"
#include "study/stability_plots.h"

namespace hsr::internal {

namespace {

/// Each face in a colour of its own, with dark edges; transparent where nothing is.
std::string sketch_png(const Image<FaceId>& faces) {
  constexpr std::array<std::array<std::uint8_t, 3>, 8> palette = {{{143, 176, 230},
                                                                   {236, 162, 140},
                                                                   {146, 205, 170},
                                                                   {199, 170, 226},
                                                                   {228, 199, 128},
                                                                   {134, 199, 210},
                                                                   {228, 158, 194},
                                                                   {190, 194, 200}}};
  Image<Colour> image(faces.width, faces.height, {0, 0, 0, 0});
  for (int j = 0; j < faces.height; ++j)
    for (int i = 0; i < faces.width; ++i) {
      const FaceId f = faces.at(i, j), right = faces.at(std::min(i + 1, faces.width - 1), j),
                   below = faces.at(i, std::min(j + 1, faces.height - 1));
      if (f != right || f != below) {
        image.at(i, j) = {70, 74, 82, 255};
      } else if (f.is_valid()) {
        const auto& [r, g, b] = palette[f.value % palette.size()];
        image.at(i, j) = {r, g, b, 255};
      }
    }
  return image_png(image);
}

/// The values from the first with the outcome on: "5e-324" or "1e-10 ... 5e-324"; empty: none.
std::string values_with(const FamilyResult& f, const StabilityRow& row, Outcome outcome) {
  std::string first, last;
  for (std::size_t k = 0; k < row.points.size(); ++k) {
    if (row.points[k].outcome != outcome) continue;
    last = short_text(f.values[k].value);
    if (first.empty()) first = last;
  }
  return first == last ? first : first + " ... " + last;
}

/// Sorted by how far along the knob the method comes.
HtmlCell breakdown_cell(const FamilyResult& f, const StabilityRow& row) {
  const auto place_of = [&](const auto& is_it) {
    return static_cast<std::size_t>(std::find_if(row.points.begin(), row.points.end(), is_it) - row.points.begin());
  };
  const auto number = [](std::size_t k) { return static_cast<double>(k); };
  if (const auto broken = f.breakdown(row))
    return {short_text(*broken), number(place_of([](const StabilityPoint& p) { return p.is_broken(); })), true};
  const std::size_t end =
      place_of([](const StabilityPoint& p) { return p.outcome == Outcome::refused || p.outcome == Outcome::left_out; });
  if (end == row.points.size()) return {"none", number(end), true};
  return {end == 0 ? "not run" : "none to " + short_text(f.values[end - 1].value), number(end), true};
}

void add_summary(HtmlPage& page, const Stability& stability) {
  page.heading("Breakdown points");
  page.paragraph(
      "The first value of each knob, on its way from easy to hard, at which a method shows another face than the nearest at "
      "some "
      "sample, or contradicts itself; it may be right again later, by luck. The exact methods, at the end of the table, have "
      "none: "
      "any would be a mistake in hsr. Where a method was not run to the end of a knob, the table says to where (why: below).");
  std::vector<std::string> columns = {"method", "numbers"};
  for (const FamilyResult& f : stability.families) columns.emplace_back(f.family.name);
  std::vector<std::vector<HtmlCell>> rows, exact;
  for (const FamilyResult& f : stability.families)
    for (const StabilityRow& row : f.rows) {
      // Formats for perspective only are in some families.
      const auto is_row = [&](const auto& r) { return r[0].text == row.method && r[1].text == row.numbers; };
      if (std::any_of(rows.begin(), rows.end(), is_row) || std::any_of(exact.begin(), exact.end(), is_row)) continue;
      std::vector<HtmlCell> cells = {{row.method}, {row.numbers}};
      for (const FamilyResult& g : stability.families) {
        const auto at =
            std::find_if(g.rows.begin(), g.rows.end(), [&](const StabilityRow& r) { return r.name() == row.name(); });
        cells.push_back(at == g.rows.end() ? HtmlCell{"-"} : breakdown_cell(g, *at));
      }
      if (row.is_exact)
        exact.push_back(std::move(cells));
      else
        rows.push_back(std::move(cells));
    }
  std::move(exact.begin(), exact.end(), std::back_inserter(rows));
  page.html("<div class=\"summary\">");
  page.table(columns, rows);
  page.html("</div>\n");
}

void add_details(HtmlPage& page, const FamilyResult& f) {
  page.html("<details><summary>All methods</summary>");
  std::vector<std::vector<HtmlCell>> rows;
  for (const StabilityRow& row : f.rows) {
    const auto broken = std::find_if(row.points.begin(), row.points.end(), [](const auto& p) { return p.is_broken(); });
    double worst = 0, seconds = 0;
    for (const StabilityPoint& p : row.points) {
      worst = std::max(worst, p.wrong_share);
      seconds += p.seconds;
    }
    std::string kinds;
    if (broken != row.points.end()) {
      const auto say = [&](std::uint64_t n, const char* kind) {
        if (n > 0) kinds += (kinds.empty() ? "" : ", ") + std::to_string(n) + " " + kind;
      };
      say(broken->edge, "edge");
      say(broken->tie, "tie");
      say(broken->order, "order");
      if (kinds.empty()) kinds = broken->why;
    }
    rows.push_back({{row.method},
                    {row.numbers},
                    breakdown_cell(f, row),
                    row.predicted ? HtmlCell{short_text(*row.predicted), *row.predicted, true} : HtmlCell{},
                    html_share(worst),
                    {kinds},
                    {values_with(f, row, Outcome::refused)},
                    {values_with(f, row, Outcome::left_out)},
                    html_number(seconds)});
  }
  page.table({"method", "numbers", "breakdown", "predicted", "most wrong samples", "at the breakdown", "refused", "left out",
              "seconds"},
             rows);
  rows.clear();
  for (const StabilityValue& v : f.values)
    rows.push_back({html_number(v.value),
                    html_number(static_cast<double>(v.triangles)),
                    {std::to_string(v.covered), static_cast<double>(v.covered), true},
                    {std::to_string(v.known), static_cast<double>(v.known), true},
                    {std::to_string(v.caster_errors), static_cast<double>(v.caster_errors), true}});
  page.table({f.family.knob, "triangles", "covered samples", "with a known answer", "exact caster differs"}, rows);
  page.html("</details>\n");
}

void add_left_out(HtmlPage& page, const Stability& stability) {
  page.heading("Refused and left out");
  std::vector<std::string> items = {"logarithmic depth buffers in parallel views: there is no ratio of distances"};
  for (const FamilyResult& f : stability.families)
    for (const StabilityRow& row : f.rows)
      for (const Outcome o : {Outcome::refused, Outcome::left_out}) {
        const auto first =
            std::find_if(row.points.begin(), row.points.end(), [&](const StabilityPoint& p) { return p.outcome == o; });
        if (first != row.points.end())
          items.push_back(std::string(f.family.name) + ", " + row.name() + ", " + f.family.knob + " " + values_with(f, row, o) +
                          ": " + first->why);
      }
  page.list(items);
}

void add_remedies(HtmlPage& page, const Stability& stability) {
  if (stability.gaps.empty()) return;
  const MeasuredGap& any = stability.gaps.front();
  page.heading("Depth: what each remedy buys");
  page.paragraph(
      "Two walls one behind the other, " + short_text(any.distance) + " from the eye, the far plane at " + short_text(any.far) +
      ": how near they may be. One step of the format is z^2 (f - n) / (n f 2^b) of b bits; both depths are rounded, "
      "so walls need some steps. Measured to a factor of two. More bits, a larger n / f and a reversed or logarithmic "
      "buffer each buy what theory says; but a float has no more than 24 bits in any of its numbers, those of the "
      "corners, too.");
  std::vector<std::vector<HtmlCell>> rows;
  for (const MeasuredGap& g : stability.gaps)
    rows.push_back({{g.drawn_by},
                    {std::string(name(g.format))},
                    html_number(g.near),
                    html_number(g.predicted),
                    g.measured > 0 ? html_number(g.measured) : HtmlCell{"none"},
                    g.measured > 0 ? html_number(g.measured / g.predicted) : HtmlCell{}});
  page.table({"drawn by", "format", "near plane", "one step", "smallest gap", "in steps"}, rows);
  page.paragraph(
      "A bias moves a wall away from the eye, so that a decal in its plane is shown: in steps of the format, and in multiples "
      "of the largest slope. It costs what may shine through: up to that gap something behind the wall is shown, too. "
      "The driver's is glPolygonOffset, which moves the decal toward the eye instead; its step is the driver's.");
  rows.clear();
  for (const MeasuredBias& b : stability.biases)
    rows.push_back({{b.drawn_by},
                    {std::string(name(b.format))},
                    html_number(b.bias),
                    html_number(b.slope_bias),
                    html_share(b.shown_share),
                    html_number(b.shines_through)});
  page.table({"drawn by", "format", "bias", "slope bias", "of the decal shown", "shines through up to a gap of"}, rows);
}

}  // namespace

std::string stability_page(const Stability& stability, const PageText& text) {
  HtmlPage page(text.title);
  page.list(text.facts);
  page.style(page_text("stability.css"));
  add_summary(page, stability);
  const std::vector<NamedPlot> plots = stability_plots(stability);
  for (std::size_t k = 0; k < stability.families.size(); ++k) {
    const FamilyResult& f = stability.families[k];
    page.heading(std::string(f.family.name) + ": " + f.family.title);
    std::uint64_t known = 0, errors = 0, samples = 0;
    for (const StabilityValue& v : f.values) {
      known += v.known;
      errors += v.caster_errors;
      samples += static_cast<std::uint64_t>(stability.size) * static_cast<std::uint64_t>(stability.size);
    }
    page.html("<div class=\"family\"><div><img alt=\"The scene from aside\" src=\"" + png_url(sketch_png(f.sketch)) + "\">");
    page.paragraph(f.family.scene_text);
    page.paragraph("Known beforehand: " + std::string(f.family.known_text) + ". That is " + std::to_string(known) + " of " +
                   std::to_string(samples) + " samples of " + std::to_string(f.values.size()) +
                   " values; the exact caster differs from it at " + std::to_string(errors) + ".");
    page.html("</div>\n");
    page.diagram(plot_svg(plots[k].plot));
    page.html("</div>\n");
    add_details(page, f);
  }
  add_remedies(page, stability);
  add_left_out(page, stability);
  return page.text();
}

}  // namespace hsr::internal
