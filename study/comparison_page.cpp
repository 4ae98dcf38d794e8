#include "study/comparison_page.h"

#include <algorithm>

#include "hsr/io/write/json_text.h"
#include "hsr/io/write/svg_text.h"
#include "study/comparison_plots.h"

namespace hsr::internal {

namespace {

std::string milliseconds(double s) { return html_number(1000 * s).text + " ms"; }

constexpr std::string_view slider_style = R"(<style>
.pick{display:flex;gap:.5rem 1.5rem;flex-wrap:wrap;align-items:center;margin:.5rem 0}
.pick label{display:flex;gap:.4rem;align-items:center}
.pair{position:relative;width:min(100%,640px);aspect-ratio:1;border:1px solid var(--faint);background:#fff;overflow:hidden;isolation:isolate}
.pair img{position:absolute;inset:0;width:100%;height:100%;image-rendering:auto}
.pair .bar{position:absolute;top:0;bottom:0;width:2px;background:#e0006c;z-index:3}
.pair.pale .truth{opacity:.25}
#position{width:min(100%,640px)}
.says{display:flex;justify-content:space-between;gap:1rem;max-width:640px;font-size:13.5px}
.says div:last-child{text-align:right}
.key span{display:inline-block;width:.8em;height:.8em;border-radius:2px;margin:0 .3em 0 1em}
</style>)";

constexpr std::string_view slider_markup = R"(
<div class="pick">
<label>left <select id="left"></select></label><label>right <select id="right"></select></label>
<label><input type="radio" name="what" value="picture" checked> picture</label>
<label><input type="radio" name="what" value="mistakes"> difference to exact</label>
<label><input type="radio" name="what" value="depth"> depth</label>
</div>
<div class="pair" id="pair"><img class="truth" id="truth" alt="What is visible, exactly"><img id="l" alt=""><img id="r" alt=""><div class="bar" id="bar"></div></div>
<input type="range" id="position" min="0" max="100" value="50" aria-label="Where the left method ends and the right one begins">
<div class="says"><div id="says-l"></div><div id="says-r"></div></div>
)";

constexpr std::string_view slider_script = R"(
const get=id=>document.getElementById(id),left=get('left'),right=get('right'),empty='data:image/gif;base64,R0lGODlhAQABAAAAACH5BAEKAAEALAAAAAABAAEAAAICTAEAOw==';
shown.forEach((m,k)=>{for(const s of [left,right])s.add(new Option(m.name,k))});
left.value=Math.min(1,shown.length-1);right.value=0;get('truth').src=shown[0].picture;
function draw(){const what=document.querySelector('input[name=what]:checked').value,at=get('position').value;
get('pair').classList.toggle('pale',what=='mistakes');
[['l',left],['r',right]].forEach(([id,s])=>{const m=shown[s.value];
get(id).src=what=='picture'?m.changes||empty:what=='mistakes'?m.mistakes||empty:m.depth||empty;
get('says-'+id).textContent=m.says+(what=='depth'&&!m.depth?' (has no depths)':'')});
get('l').style.clipPath='inset(0 '+(100-at)+'% 0 0)';get('r').style.clipPath='inset(0 0 0 '+at+'%)';get('bar').style.left='calc('+at+'% - 1px)'}
for(const e of [left,right,get('position'),...document.querySelectorAll('input[name=what]')])e.addEventListener('input',draw);
get('pair').addEventListener('pointermove',e=>{if(e.buttons){const b=get('pair').getBoundingClientRect();get('position').value=100*(e.clientX-b.left)/b.width;draw();e.preventDefault()}});
draw();
)";

void add_slider(HtmlPage& page, const Comparison& c, const std::vector<ComparisonImages>& images) {
  page.heading("Two methods beside each other");
  page.html(slider_style);
  page.html(slider_markup);
  std::string legend = "<p class=\"key\">Differences:";
  for (const auto& [mistake, words] :
       {std::pair(Mistake::edge, "edge misplaced"), std::pair(Mistake::tie, "tie within the depth format"),
        std::pair(Mistake::order, "wrong order")}) {
    legend += "<span style=\"background:";
    append_colour(legend, mistake_colour(mistake));
    legend += "\"></span>" + std::string(words);
  }
  page.html(legend + "</p>\n");
  std::string data = "const shown=[";
  const auto add = [&](const std::string& name, const std::string& says, const ComparisonImages& i, bool is_truth) {
    data += "{name:";
    append_string(data, name);
    data += ",says:";
    append_string(data, says);
    const auto url = [&](const char* key, const std::string& png) {
      data += std::string(",") + key + ":\"" + (png.empty() ? "" : png_url(png)) + "\"";
    };
    if (is_truth) url("picture", i.shown);
    url("changes", is_truth ? "" : i.changes);
    url("mistakes", is_truth ? "" : i.mistakes);
    url("depth", i.depth);
    data += "},\n";
  };
  if (!images.empty()) add("exact", "exact", images[0], true);
  for (const ComparedMethod& m : c.methods)
    if (m.picture >= 0)
      add(m.name(),
          m.name() + ": " + std::to_string(m.wrong) + " of " + std::to_string(m.covered) + " samples wrong, " +
              milliseconds(m.median()),
          images[static_cast<std::size_t>(m.picture)], false);
  page.script(data + "];\n");
  page.script(slider_script);
}

void add_colours(HtmlPage& page, const std::vector<ComparedColours>& compared) {
  std::vector<std::vector<HtmlCell>> rows;
  rows.reserve(compared.size());
  for (const ComparedColours& c : compared)
    rows.push_back({{c.method},
                    {c.samples},
                    html_number(c.seconds),
                    c.bytes == 0 ? HtmlCell{} : html_bytes(static_cast<double>(c.bytes)),
                    html_number(c.mean_difference),
                    html_number(c.most_difference),
                    html_share(c.changed_share)});
  page.table({"method", "samples to a pixel", "seconds", "working storage", "mean difference", "largest", "changed"}, rows);
}

}  // namespace

std::string comparison_page(const Comparison& c, const std::vector<ComparisonImages>& images, const PageText& text) {
  HtmlPage page(text.title);
  page.list(text.facts);
  add_slider(page, c, images);

  page.heading("Error against run time");
  page.paragraph(
      "Both axes by powers of ten. A point is a method at one resolution; exact methods have no error and stand on the line "
      "below the diagram. Wrong area: each pixel is taken as a square of what its sample shows, and compared with the exact "
      "fragments in it. One thread each unless said otherwise. Methods whose points would lie on others' are in the table "
      "alone.");
  page.html("<div class=\"plots\">");
  for (const NamedPlot& p : comparison_plots(c)) page.html(plot_svg(p.plot));
  page.html("</div>");

  page.heading("All figures");
  page.paragraph(
      "Seconds by the clock: the median of the runs, which were shuffled, the least and the most. Memory: the most that was "
      "taken during the first run. Edge error: wrong area over the length of all visible edges, in pixels. Click or press "
      "Enter "
      "on a head to sort.");
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

  page.heading("Stages: what they cost and save");
  rows.clear();
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
