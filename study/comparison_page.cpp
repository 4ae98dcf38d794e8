#include "study/comparison_page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>

#include "hsr/io/write/json_text.h"
#include "hsr/io/write/svg_text.h"
#include "study/comparison_plots.h"
#include "study/explain/explained_methods.h"
#include "study/page_texts.h"

namespace hsr::internal {

namespace {

std::string milliseconds(double s) { return html_number(1000 * s).text + " ms"; }

/// What of the pictures the page has: of all methods first where they are wrong, then what they show there, then depths, as long as it
/// stays under 5 MB. The files beside it have them all, but for the depths.
class Budget {
 public:
  explicit Budget(const std::vector<ComparisonImages>& images) {
    if (!images.empty()) left_ -= std::min(left_, images[0].shown.size());
    for (const auto member : {&ComparisonImages::mistakes, &ComparisonImages::changes, &ComparisonImages::depth})
      for (const ComparisonImages& i : images)
        if ((i.*member).size() <= left_) {
          left_ -= (i.*member).size();
          kept_.insert(&(i.*member));
        }
  }
  bool has(const std::string& png) const { return kept_.count(&png) > 0; }

 private:
  std::size_t left_ = 3'400'000;  // as text they are a third larger
  std::set<const std::string*> kept_;
};

void add_slider(HtmlPage& page, const Comparison& c, const std::vector<ComparisonImages>& images) {
  page.heading("Two methods beside each other");
  page.style(page_text("compare.css"));
  page.html(page_text("compare.html"));
  std::string legend = "<p class=\"key\">Differences:";
  for (const auto& [mistake, words] :
       {std::pair(Mistake::edge, "edge misplaced"), std::pair(Mistake::tie, "tie within the depth format"),
        std::pair(Mistake::order, "wrong order")}) {
    legend += "<span style=\"background:";
    append_colour(legend, mistake_colour(mistake));
    legend += "\"></span>" + std::string(words);
  }
  page.html(legend + "</p>\n");
  const Budget budget(images);
  std::string data = "const shown=[";
  const auto add = [&](const std::string& name, const std::string& says, const ComparisonImages& i,
                       const ComparedMethod* method) {
    const bool is_truth = method == nullptr;
    data += "{wrong:" + std::to_string(is_truth ? 0 : method->wrong) +
            ",covered:" + std::to_string(is_truth ? c.methods.empty() ? 0 : c.methods.front().covered : method->covered) +
            ",name:";
    append_string(data, name);
    data += ",says:";
    append_string(data, says);
    bool is_all = true;
    const auto url = [&](const char* key, const std::string& png, bool is_wanted) {
      const bool is_kept = is_wanted && !png.empty() && (is_truth || budget.has(png));
      is_all = is_all && (is_kept || png.empty() || !is_wanted);
      data += std::string(",") + key + ":\"" + (is_kept ? png_url(png) : "") + "\"";
    };
    if (is_truth) url("picture", i.shown, true);
    url("changes", i.changes, !is_truth);
    url("mistakes", i.mistakes, !is_truth);
    url("depth", i.depth, true);
    if (!is_all) data += ",large:true";
    data += "},\n";
  };
  if (!images.empty()) add("exact", "exact", images[0], nullptr);
  for (const ComparedMethod& m : c.methods)
    if (m.picture >= 0)
      add(m.name(),
          m.name() + ": " + std::to_string(m.wrong) + " of " + std::to_string(m.covered) + " samples wrong, " +
              milliseconds(m.median()),
          images[static_cast<std::size_t>(m.picture)], &m);
  page.script(data + "];\n");
  page.script(page_text("compare.js"));
}

/// The page of hsr explain that shows the method; empty: there is none.
std::string explained_by(const std::string& method) {
  // The first that the name begins with.
  constexpr std::array<std::array<std::string_view, 2>, 15> pages = {{{"scanline", "scanline"},
                                                                      {"painter, for each pixel", "alpha-buffer"},
                                                                      {"painter, by", "painter"},
                                                                      {"depth sort", "depth-sort"},
                                                                      {"BSP", "bsp"},
                                                                      {"row z-buffer", "row-z-buffer"},
                                                                      {"tiled z-buffer", "tiled-z-buffer"},
                                                                      {"z-buffer", "z-buffer"},
                                                                      {"depth buffer", "z-buffer"},
                                                                      {"OpenGL", "z-buffer"},
                                                                      {"ray casting", "ray-casting"},
                                                                      {"alpha-buffer", "alpha-buffer"},
                                                                      {"A-buffer", "a-buffer"},
                                                                      {"visible fragments", "fragments"},
                                                                      {"Roberts", "roberts"}}};
  for (const auto& [begins, page] : pages) {
    if (method.rfind(begins, 0) != 0) continue;
    const std::vector<ExplainedMethod>& all = explained_methods();
    const bool is_there =
        std::any_of(all.begin(), all.end(), [&, &page = page](const ExplainedMethod& m) { return m.name == page; });
    return is_there ? "explain/" + std::string(page) + ".html" : std::string();
  }
  return {};
}

void add_colours(HtmlPage& page, const std::vector<ComparedColours>& compared) {
  std::vector<std::vector<HtmlCell>> rows;
  rows.reserve(compared.size());
  for (const ComparedColours& c : compared) {
    HtmlCell name{c.method};
    name.link = explained_by(c.method);
    rows.push_back({std::move(name),
                    {c.samples},
                    html_number(c.seconds),
                    c.bytes == 0 ? HtmlCell{} : html_bytes(static_cast<double>(c.bytes)),
                    html_number(c.mean_difference),
                    html_number(c.most_difference),
                    html_share(c.changed_share)});
  }
  page.table({"method", "samples to a pixel", "seconds", "working storage", "mean difference", "largest", "changed"}, rows);
}

/// How far the runs of a method lie from their median, as a median. @pre seconds are sorted
double scatter(const ComparedMethod& m) {
  std::vector<double> off;
  for (const double s : m.seconds) off.push_back(std::fabs(s - m.median()));
  std::sort(off.begin(), off.end());
  return off[off.size() / 2];
}

/// How long against the fastest of a group, where that is more than what runs of the two scatter.
HtmlCell against(const ComparedMethod& m, const ComparedMethod& fastest) {
  const double ratio = fastest.median() > 0 ? m.median() / fastest.median() : 1;
  if (&m == &fastest) return {"fastest", ratio, true};
  if (m.seconds.size() > 1 && m.median() - fastest.median() <= 2 * (scatter(m) + scatter(fastest)))
    return {"within noise", ratio, true};
  return {rounded_text(ratio, 3) + " times", ratio, true};
}

/// At the size of the pictures, in groups: what matters of each method.
void add_methods(HtmlPage& page, const Comparison& c) {
  page.heading("The methods, " + std::to_string(c.size) + " x " + std::to_string(c.size));
  page.paragraph(
      "Seconds: the median of the runs, and the least of them. Against the fastest of its group a method is within noise where "
      "their "
      "medians differ by no more than twice what their runs scatter. A name leads to a page that shows the method step by "
      "step. Click or "
      "press Enter on a head to sort within the groups.");
  const auto group_of = [](const ComparedMethod& m) {
    return m.is_object_space && m.is_exact                                                    ? 0U
           : m.is_object_space                                                                ? 1U
           : m.method.find("buffer") != std::string::npos || m.method.rfind("OpenGL", 0) == 0 ? 2U
                                                                                              : 3U;
  };
  std::vector<HtmlGroup> groups = {{"Object space, exact", {}},
                                   {"Object space, in doubles", {}},
                                   {"z-buffers, the last of them the driver's", {}},
                                   {"Other methods of image space", {}}};
  std::vector<const ComparedMethod*> fastest(groups.size(), nullptr);
  for (const ComparedMethod& m : c.methods)
    if (const std::size_t g = group_of(m); m.picture >= 0 && (fastest[g] == nullptr || m.median() < fastest[g]->median()))
      fastest[g] = &m;
  const auto count = [](std::uint64_t n) { return HtmlCell{std::to_string(n), static_cast<double>(n), true}; };
  for (const ComparedMethod& m : c.methods) {
    if (m.picture < 0) continue;
    const std::size_t g = group_of(m);
    HtmlCell name{m.name()};
    name.link = explained_by(m.method);
    groups[g].rows.push_back({std::move(name),
                              count(m.wrong),
                              html_share(m.wrong_area_share),
                              html_number(m.median()),
                              html_number(m.seconds.front()),
                              against(m, *fastest[g]),
                              html_bytes(static_cast<double>(m.peak_bytes)),
                              {m.note}});
  }
  std::erase_if(groups, [](const HtmlGroup& g) { return g.rows.empty(); });
  page.table({"method", "wrong samples", "wrong area", "seconds", "least", "against the fastest", "memory", "note"}, groups,
             "fits");
}

void add_all_figures(HtmlPage& page, const Comparison& c) {
  page.html("<details><summary>All sizes, all figures</summary>\n");
  page.paragraph(
      "Seconds by the clock: the median of the runs, which were shuffled, the least and the most. Memory: the most that was "
      "taken during the "
      "first run. Edge error: wrong area over the length of all visible edges, in pixels.");
  std::vector<std::vector<HtmlCell>> rows;
  for (const ComparedMethod& m : c.methods) {
    const auto count = [](std::uint64_t n) { return HtmlCell{std::to_string(n), static_cast<double>(n), true}; };
    rows.push_back({{m.method},
                    {m.numbers},
                    {m.is_object_space ? "object" : "image"},
                    count(static_cast<std::uint64_t>(m.size)),
                    html_number(m.median()),
                    html_number(m.seconds.front()),
                    html_number(m.seconds.back()),
                    count(m.seconds.size()),
                    html_bytes(static_cast<double>(m.peak_bytes)),
                    count(m.wrong),
                    html_share(m.wrong_share()),
                    count(m.edge),
                    count(m.tie),
                    count(m.order),
                    html_share(m.wrong_area_share),
                    html_number(m.edge_error),
                    {m.note}});
  }
  page.table({"method", "numbers", "space", "samples each way", "seconds", "least", "most", "runs", "memory", "wrong samples",
              "of covered", "edge", "tie", "order", "wrong area", "edge error", "note"},
             rows);
  page.html("</details>\n");
}

}  // namespace

std::string comparison_page(const Comparison& c, const std::vector<ComparisonImages>& images, const PageText& text) {
  HtmlPage page(text.title);
  page.list(text.facts);
  add_slider(page, c, images);
  add_methods(page, c);

  page.heading("Error against run time");
  page.paragraph(
      "Both axes by powers of ten. A point is a method at one resolution; exact methods have no error and stand on the line "
      "below the diagram. Wrong area: each pixel is taken as a square of what its sample shows, and compared with the exact "
      "fragments in it. One thread each unless said otherwise. Methods whose points would lie on others' are in the table "
      "alone.");
  page.html("<div class=\"plots\">");
  for (const NamedPlot& p : comparison_plots(c)) page.diagram(plot_svg(p.plot));
  page.html("</div>");

  add_all_figures(page, c);

  std::vector<std::vector<HtmlCell>> rows;
  page.heading("Stages: what they cost and save");
  for (const ComparedStage& s : c.stages)
    rows.push_back(
        {{s.stage}, {s.kind}, html_number(s.seconds), html_number(s.without), html_number(s.without - s.seconds), {s.result}});
  page.table({"stage", "kind", "seconds with it", "without", "saved", "result"}, rows);

  const std::string pixels = std::to_string(std::max(1, c.size / 4)) + " pixels each way";
  constexpr const char* levels = " Differences in levels of 0 ... 255; changed: pixels that are more than one level off.";
  if (!c.supersampling.empty()) {
    page.heading("Supersampling");
    page.paragraph("Each face in a colour of its own, " + pixels + ", against 16 x 16 exact rays to a pixel." + levels);
    add_colours(page, c.supersampling);
  }
  if (!c.transparency.empty()) {
    page.heading("Transparency");
    page.paragraph("Each face in a colour of its own and half transparent, " + pixels +
                   ", against the exact painter's order with 8 x 8 samples to a pixel." + levels);
    add_colours(page, c.transparency);
  }

  page.heading("Left out");
  std::vector<std::string> left_out;
  for (const LeftOut& l : c.left_out) left_out.push_back(l.stage + ": " + l.why);
  if (left_out.empty()) left_out.push_back("nothing");
  page.list(left_out);
  return page.text();
}

}  // namespace hsr::internal
