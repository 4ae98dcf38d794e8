#include "tests/io/write/other_programs.h"

#include <catch2/catch.hpp>

#include "hsr/drawing/painting.h"
#include "hsr/io/write/eps.h"
#include "hsr/io/write/hpgl.h"
#include "hsr/io/write/pdf.h"
#include "hsr/io/write/svg.h"
#include "hsr/io/write/tikz.h"
#include "hsr/painter/bsp/bsp.h"
#include "hsr/painter/sort/depth_sort.h"
#include "hsr/raster/caster.h"
#include "tests/drawing/round_models.h"
#include "tests/io/write/plain_lines.h"

// What hsr writes, read by programs that are not ours, against the exact answer. A program that is missing is told of and passed
// over: packages.txt names those that tests/run installs, packages-long.txt those that only the long tests need.

using namespace hsr;
using namespace hsr::internal;

namespace {

constexpr int dots = 20;  // to a millimetre: 508 to the inch
constexpr double margin = 0.08;

/// How a format is turned into picture.png in the workplace, from the file drawn.<format>.
struct Renderer {
  const char* program;
  const char* format;
  const char* command;
};

const Renderer renderers[] = {
    {"rsvg-convert", "svg", "rsvg-convert -w 1524 -h 1016 -b white -o picture.png drawn.svg"},
    {"pdftoppm", "pdf", "pdftoppm -r 508 -png -singlefile drawn.pdf picture"},
    {"mutool", "pdf", "mutool draw -q -r 508 -o picture.png drawn.pdf"},
    {"gs", "eps",
     "gs -q -dSAFER -dNOPAUSE -dBATCH -dEPSCrop -r508 -sDEVICE=png16m -dGraphicsAlphaBits=4 -sOutputFile=picture.png "
     "drawn.eps"},
};

std::string bytes_of(const Drawing& drawing, const std::string& format) {
  return format == "svg" ? svg(drawing) : format == "pdf" ? pdf(drawing) : format == "eps" ? eps(drawing) : tikz(drawing);
}

RenderedPage rendered(const Renderer& r, const std::string& bytes) {
  const Workplace here("hsr_rendered");
  here.write(std::string("drawn.") + r.format, bytes);
  int status = 0;
  INFO(here.run(r.command, status));
  REQUIRE(status == 0);
  RenderedPage page = read_png(here / "picture.png");
  REQUIRE(page.width == 1524);
  REQUIRE(page.height == 1016);
  return page;
}

/// Pixels that show something else than the exact drawing.
ExactPicture::Wrong wrong_in(const Renderer& r, const DrawnScene& scene, const Drawing& expected, const std::string& bytes) {
  return ExactPicture(scene, expected).compare(rendered(r, bytes), dots, !expected.fills.fills.empty(), margin);
}

void check_right(const Renderer& r, const DrawnScene& scene, const Drawing& drawing) {
  CAPTURE(r.program);
  const auto wrong = wrong_in(r, scene, drawing, bytes_of(drawing, r.format));
  CHECK(wrong.seen > 350000);
  CHECK(wrong.lines == 0);
  CHECK(wrong.dashes == 0);
  CHECK(wrong.areas == 0);
}

}  // namespace

TEST_CASE("Other programs show SVG, PDF and EPS as the exact drawing is, filled and not", "[write][others][D11]") {
  const DrawnScene scene;
  for (const Renderer& r : renderers) {
    if (!is_there(r.program)) continue;
    check_right(r, scene, scene.draw(true));
    check_right(r, scene, scene.draw(false));
  }
}

TEST_CASE("Inkscape shows SVG as the exact drawing is, filled and not", "[write][others][long][D11]") {
  const Renderer inkscape = {"inkscape", "svg",
                             "HOME=. inkscape --export-type=png --export-filename=picture.png --export-width=1524 "
                             "--export-height=1016 --export-background=white drawn.svg"};
  if (!is_there(inkscape.program)) return;
  const DrawnScene scene;
  check_right(inkscape, scene, scene.draw(true));
  check_right(inkscape, scene, scene.draw(false));
}

TEST_CASE("A lost hole, a pen that is too wide, a lost dash and a swapped layer are found in pictures", "[write][others]") {
  const DrawnScene scene;
  const Drawing right = scene.draw();
  const auto wrong_with = [&](const auto& plant) {
    Drawing planted = right;
    plant(planted);
    const Renderer& r = renderers[1];
    return wrong_in(r, scene, right, bytes_of(planted, r.format));
  };
  if (!is_there(renderers[1].program)) return;
  REQUIRE(wrong_with([](Drawing&) {}).all() == 0);
  CHECK(wrong_with([](Drawing& d) {  // of the plate: the box and the hole
          for (Fill& fill : d.fills.fills)
            if (fill.end_ring - fill.first_ring > 1) fill.end_ring = fill.first_ring + 1;
        })
            .areas > 1000);
  CHECK(wrong_with([](Drawing& d) {
          for (Polyline& p : d.polylines)
            if (p.edge_class == EdgeClass::smooth) p.edge_class = EdgeClass::outline;
        }).areas > 100);
  CHECK(wrong_with([](Drawing& d) { d.pens = Pens(0.5, HiddenLines::solid); }).dashes > 100);
  CHECK(wrong_with([](Drawing& d) {
          for (Polyline& p : d.polylines) p.hidden = !p.hidden;
        }).lines > 1000);
  CHECK(wrong_with([](Drawing& d) { d.polylines.pop_back(); }).lines > 10);
  CHECK(wrong_with([](Drawing& d) { std::swap(d.fills.fills.front().colour, d.fills.fills.back().colour); }).areas > 1000);
}

TEST_CASE("Other programs show a painting order as the exact drawing is", "[write][others][D21]") {
  const DrawnScene scene;
  LineOptions lines;
  lines.classes.fill(true);
  DrawingOptions page = scene.page();
  page.hidden = HiddenLines::none;
  const BspTree tree(scene.mesh);
  for (const PaintersOrder& order : {depth_sort(scene.scene).order, tree.order(scene.scene)}) {
    const Drawing drawing = paint_on_page(scene.scene, order, scene.colours, lines, page);
    for (const Renderer& r : renderers)
      if (is_there(r.program)) check_right(r, scene, drawing);
  }
}

TEST_CASE("Other programs show all layers of what is seen through", "[write][others][D21]") {
  const DrawnScene scene;
  LineOptions no_lines;
  no_lines.classes = {};
  DrawingOptions page = scene.page();
  page.hidden = HiddenLines::none;
  const PaintersOrder order = depth_sort(scene.scene).order;
  const PaperRectangle all = paper_rectangle(scene.mesh, scene.view);
  const double x = (all.left + all.right) / 2, y = (all.bottom + all.top) / 2,
               half_width = DrawnScene::width / 2 / DrawnScene::scale, half_height = DrawnScene::height / 2 / DrawnScene::scale;
  const SampleGrid grid =
      sample_grid(scene.view, PaperRectangle{x - half_width, x + half_width, y - half_height, y + half_height}, 1524, 1016);
  for (const double opacity : {0.3, 0.8}) {
    const Image<Colour> exact = paint(scene.scene, order, grid, scene.colours, opacity);
    const Drawing drawing = paint_on_page(scene.scene, order, scene.colours, no_lines, page, {.opacity = opacity});
    for (const Renderer& r : renderers) {
      if (r.format == std::string("eps") || !is_there(r.program)) continue;
      CAPTURE(r.program, opacity);
      const RenderedPage picture = rendered(r, bytes_of(drawing, r.format));
      int seen = 0, wrong = 0;
      for (int j = 1; j + 1 < picture.height; ++j)
        for (int i = 1; i + 1 < picture.width; ++i) {
          bool is_inner = true;  // no border runs through the pixel or beside it
          for (int k = 0; k < 9; ++k) is_inner = is_inner && exact.at(i + k % 3 - 1, j + k / 3 - 1) == exact.at(i, j);
          if (!is_inner) continue;
          ++seen;
          for (std::size_t k = 0; k < 3; ++k)
            if (std::abs(int(picture.at(i, j)[k]) - int(exact.at(i, j)[k])) > 3) {
              ++wrong;
              break;
            }
        }
      CHECK(seen > 1000000);
      CHECK(wrong < 700);  // fine seams between layers of one surface
    }
  }
  CHECK_THROWS_AS(eps(paint_on_page(scene.scene, order, scene.colours, no_lines, page, {.opacity = 0.5})), InputError);
}

TEST_CASE("A PDF is sound, has a layer for each visibility and class, and the page in points", "[write][others][D12]") {
  const DrawnScene scene;
  const Drawing drawing = scene.draw();
  const Workplace here("hsr_pdf");
  here.write("drawn.pdf", pdf(drawing, "a \xC3\xA9 (\\"));
  int status = 0;
  if (is_there("qpdf")) {
    const std::string said = here.run("qpdf --check drawn.pdf", status);
    INFO(said);
    CHECK(status == 0);
    const std::string all = here.run("qpdf --qdf --object-streams=disable drawn.pdf -", status);
    std::string names;
    for (std::size_t at = all.find("/Name ("); at != std::string::npos; at = all.find("/Name (", at + 1))
      names += all.substr(at + 7, all.find(')', at) - at - 7) + ",";
    CHECK(names == "visible smooth,visible boundary,visible sharp,visible outline,hidden sharp,hidden outline,fill,");
  }
  if (is_there("qpdf")) {  // objects are layers within the layers
    Drawing told_apart = drawing;
    told_apart.objects = {"plate", "box"};
    for (std::size_t k = 0; k < told_apart.polylines.size(); ++k) told_apart.polylines[k].object = k % 4 == 3 ? 1 : 0;
    here.write("objects.pdf", pdf(told_apart));
    const std::string said = here.run("qpdf --check objects.pdf", status);
    INFO(said);
    CHECK(status == 0);
  }
  if (is_there("pdfinfo")) {
    const std::string said = here.run("pdfinfo drawn.pdf", status);
    INFO(said);
    CHECK(said.find("Page size:       216 x 144 pts") != std::string::npos);
    CHECK(said.find("Title:           a \xC3\xA9 (\\") != std::string::npos);
  }
}

namespace {

/// A cylinder of few sides, whose rims are circles within a quarter of a millimetre, in thin continuous pens: 48 by 78 mm.
Drawing thin_cylinder(double tolerance, HiddenLines hidden) {
  const Mesh mesh = cylinder(24, 24, 60);
  DrawingOptions options;
  options.page = parse_page("76.2x50.8mm");
  options.scale = 0.5;
  options.hidden = hidden;
  options.fit_arcs = tolerance;
  options.pens = parse_pens("visible=0.14,hidden=0.14");
  const View view = named_view("iso");
  return draw(mesh, view, visible_lines(mesh, view), options);
}

bool is_inked(const RenderedPage& page, const Point2& p) { return page.at(int(p.x * dots), int(p.y * dots))[0] < 100; }

}  // namespace

TEST_CASE("Other programs show arcs where the circle is, from the lines' ends on", "[write][others][D22]") {
  const Drawing arcs = thin_cylinder(0.125, HiddenLines::solid), dashed = thin_cylinder(0.125, HiddenLines::dashed),
                lines = thin_cylinder(0, HiddenLines::solid);
  REQUIRE(arcs.arcs.size() == 4);
  REQUIRE(lines.arcs.empty());
  for (const Renderer& r : renderers) {
    if (!is_there(r.program)) continue;
    CAPTURE(r.program);
    const RenderedPage curved = rendered(r, bytes_of(arcs, r.format)), straight = rendered(r, bytes_of(lines, r.format)),
                       broken = rendered(r, bytes_of(dashed, r.format));
    int off = 0, off_straight = 0, down = 0, hidden = 0;
    for (const Polyline& p : arcs.polylines)
      for (const DrawnArc& arc : arcs.arcs_of(p))
        for (int k = 1; k < 500; ++k) {
          const Point2 at = arc.ellipse.at(arc.ellipse.from + k * arc.ellipse.sweep() / 500);
          if (!is_inked(curved, at)) ++off;
          if (!is_inked(straight, at)) ++off_straight;
          if (p.hidden) ++hidden;
          if (p.hidden && is_inked(broken, at)) ++down;
        }
    CHECK(off == 0);
    CHECK(off_straight > 400);  // the test tells the two apart
    CHECK(down > 0.7 * hidden);
    CHECK(down < 0.9 * hidden);
    int ink = 0, ink_of_lines = 0;  // and nothing more is drawn
    for (std::size_t k = 0; k < curved.bytes.size(); k += 3) {
      ink += curved.bytes[k] < 100 ? 1 : 0;
      ink_of_lines += straight.bytes[k] < 100 ? 1 : 0;
    }
    CHECK(ink == Approx(ink_of_lines).epsilon(0.03));
  }
}

namespace {

struct PaperBox {
  std::int64_t left, top, right, bottom;
};

PaperBox box_of(const Drawing& drawing) {
  const auto [left, right] = std::ranges::minmax(drawing.points, {}, &PaperPoint::x);
  const auto [top, bottom] = std::ranges::minmax(drawing.points, {}, &PaperPoint::y);
  return {left.x, top.y, right.x, bottom.y};
}

std::vector<PlainLine> lines_on_paper(const Drawing& drawing) {
  std::vector<PlainLine> lines;
  for (const Polyline& p : drawing.polylines) {
    const auto at = drawing.points_of(p);
    for (std::size_t k = 0; k + (p.closed ? 0 : 1) < at.size(); ++k) {
      const PaperPoint &a = at[k], &b = at[(k + 1) % at.size()];
      lines.push_back({{double(a.x), double(a.y)}, {double(b.x), double(b.y)}, p.hidden});
    }
  }
  return lines;
}

bool is_inked_near(const RenderedPage& page, int x, int y) {
  for (int dx = -3; dx <= 3; ++dx)
    for (int dy = -3; dy <= 3; ++dy)
      if (page.at(std::clamp(x + dx, 0, page.width - 1), std::clamp(y + dy, 0, page.height - 1))[0] < 128) return true;
  return false;
}

/// Points of visible lines without ink, and ink far from all lines, in what hp2xx makes of `written`. It cuts the picture to the
/// lines: true size, ten dots to the millimetre.
std::array<int, 2> wrong_ink(const Drawing& written, const Drawing& expected) {
  const Workplace here("hsr_hpgl");
  here.write("drawn.hpgl", hpgl(written));
  int status = 0;
  INFO(here.run("hp2xx -q -t -d 254 -p 11111111 -m png -f picture.png drawn.hpgl", status));
  REQUIRE(status == 0);
  const RenderedPage page = read_png(here / "picture.png");
  REQUIRE(page.width > 0);
  const PaperBox box = box_of(expected);
  const std::vector<PlainLine> lines = lines_on_paper(expected);
  std::array<int, 2> wrong = {0, 0};
  for (const PlainLine& l : lines)
    for (const double t : {0.1, 0.3, 0.5, 0.7, 0.9}) {
      const double x = l.a.x + t * (l.b.x - l.a.x) - double(box.left), y = l.a.y + t * (l.b.y - l.a.y) - double(box.top);
      if (!l.is_hidden && !is_inked_near(page, int(x / 100), int(y / 100))) ++wrong[0];
    }
  for (int y = 0; y < page.height; ++y)
    for (int x = 0; x < page.width; ++x) {
      if (page.at(x, y)[0] > 127) continue;
      const Point2 p = {x * 100.0 + double(box.left), y * 100.0 + double(box.top)};
      if (std::none_of(lines.begin(), lines.end(), [&](const PlainLine& l) { return distance(p, l.a, l.b) < 400; })) ++wrong[1];
    }
  return wrong;
}

}  // namespace

TEST_CASE("hp2xx draws the HPGL where the exact drawing has lines", "[write][others][D14]") {
  if (!is_there("hp2xx")) return;
  const DrawnScene scene;
  const Drawing drawing = scene.draw(false);
  CHECK(wrong_ink(drawing, drawing) == std::array{0, 0});
  Drawing planted = drawing;  // a line lost
  planted.polylines.pop_back();
  CHECK(wrong_ink(planted, drawing)[0] > 0);
  planted = drawing;  // the end of a line moved by 5 mm, within the picture
  PaperPoint& end = planted.points[planted.polylines.back().first_point];
  end.y += 2 * end.y > box_of(drawing).top + box_of(drawing).bottom ? -5000 : 5000;
  CHECK(wrong_ink(planted, drawing)[1] > 0);
}

TEST_CASE("pdflatex shows TikZ as the exact drawing is, alone and in a document, with styles by name",
          "[write][others][long]") {
  if (!is_there("pdflatex") || !is_there("pdftoppm")) return;
  const DrawnScene scene;
  const Renderer tex = {"pdflatex", "tex",
                        "pdflatex -interaction=batchmode drawn.tex && pdftoppm -r 508 -png -singlefile drawn.pdf picture"};
  check_right(tex, scene, scene.draw(true));
  check_right(tex, scene, scene.draw(false));
  const Workplace here("hsr_tex");
  here.write("drawn.tex", tikz(scene.draw(false)));
  here.write(
      "paper.tex",
      "\\documentclass{article}\\usepackage{tikz}\\pagestyle{empty}\\begin{document}Before.\n"
      "\\tikzset{hsr visible outline/.style={draw=red, line width=1mm}}\n\\noindent\\input{drawn}\n\nAfter.\\end{document}\n");
  int status = 0;
  const std::string said = here.run(
      "pdflatex -interaction=nonstopmode paper.tex && pdftotext paper.pdf - && pdftoppm -r 100 -png -singlefile paper.pdf "
      "picture",
      status);
  INFO(said);
  REQUIRE(status == 0);
  CHECK(said.find("After.") != std::string::npos);
  const RenderedPage page = read_png(here / "picture.png");
  int red = 0, black = 0;
  for (std::size_t k = 0; k < page.bytes.size(); k += 3) {
    if (page.bytes[k] > 240 && page.bytes[k + 1] < 20) ++red;
    if (page.bytes[k] < 60) ++black;
  }
  CHECK(red > 500);
  CHECK(black > 500);
}
