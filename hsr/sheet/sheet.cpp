#include "hsr/sheet/sheet.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <mutex>
#include <numeric>

#include "geometry/error.h"
#include "hsr/drawing/section_drawing.h"
#include "hsr/sheet/annotations.h"
#include "hsr/sheet/model_circles.h"
#include "hsr/sheet/paper_box.h"
#include "hsr/sheet/round_part.h"
#include "hsr/sheet/sheet_frame.h"
#include "hsr/sheet/sheet_layout.h"
#include "hsr/sheet/sheet_views.h"
#include "hsr/sheet/stroke_font.h"
#include "hsr/sheet/title_block.h"

namespace hsr {

using namespace internal;

namespace {

constexpr double inset = 5;              // mm, from the frame to what is drawn
constexpr double dimension_offset = 12;  // from the model to the dimension line
constexpr double letters_offset = 10;    // more, where the end of a cutting line has its letter
constexpr double over_dimension = 7;     // of its text and its extension lines
constexpr double label_room = 10, cutting_room = 18;
constexpr std::size_t most_circles = 4000;

std::string number_text(double x) {
  char digits[32];
  const double rounded = std::round(x * 100) / 100;
  const auto [end, error] = std::to_chars(digits, digits + sizeof digits, rounded + 0.0);
  return {digits, end};
}

/// From the views to the page, one step after the other.
class SheetMaker {
 public:
  SheetMaker(const Scene& scene, const SheetOptions& options)
      : scene_(scene), options_(options), views_(views_of_sheet(scene, options)), pens_{line_group(page())} {}

  Sheet sheet() {
    place();
    draw_views();
    draw_annotations();
    return std::move(sheet_);
  }

 private:
  Page page() const { return {options_.format.width, options_.format.height, 0, false, false}; }
  bool dimensions_at(const SheetView& v) const { return options_.has_dimensions && (v.name == "front" || v.name == "top"); }

  void place() {
    std::vector<ViewToPlace> places;
    for (const SheetView& v : views_) places.push_back(place_of(v));
    sheet_.frame = options_.format.frame();
    sheet_.title_block = title_block_place(sheet_.frame);
    const PaperFrame& f = sheet_.frame;
    const PaperFrame area = {f.left + inset, f.top + inset, f.right - inset, f.bottom - inset};
    const auto layout = lay_out(places, area, sheet_.title_block, options_.angle, options_.scale);
    if (!layout) refuse(places, area);
    sheet_.scale = layout->scale;
    for (std::size_t k = 0; k < views_.size(); ++k) {
      const SheetView& v = views_[k];
      // Whole hundredths of a millimetre, so that what is alike in two views is rounded alike.
      const auto rounded = [](double mm) { return std::round(mm * 100) / 100; };
      const double scale = (v.detail != nullptr ? v.detail->scale : layout->scale) * options_.unit;
      const Point2 at = {rounded(layout->origins[k].x), rounded(layout->origins[k].y)};
      const auto& r = v.rectangle;
      sheet_.views.push_back({v.name,
                              v.label,
                              v.view,
                              at,
                              scale,
                              {at.x + scale * r.left, at.y - scale * r.top, at.x + scale * r.right, at.y - scale * r.bottom}});
    }
  }

  ViewToPlace place_of(const SheetView& v) const {
    ViewToPlace p;
    p.row = v.is_in_top_row ? ViewToPlace::Row::of_top : ViewToPlace::Row::of_front;
    p.lines_up = v.lines_up;
    p.is_free = !v.lines_up;
    p.is_on_paper = v.detail != nullptr;
    const double s = options_.unit * (p.is_on_paper ? v.detail->scale : 1);
    p.left = -s * v.rectangle.left;
    p.right = s * v.rectangle.right;
    p.above = s * v.rectangle.top;
    p.below = -s * v.rectangle.bottom;
    if (!v.label.empty()) p.pad_above = label_room;
    // The ends of the cutting line with their arrows.
    if (is_cut(v.name)) p.pad_left = p.pad_right = p.pad_above = p.pad_below = cutting_room;
    const double room = offset_of_dimension(v.name) + over_dimension;
    if (dimensions_at(v)) p.pad_left = room;
    if (options_.has_dimensions && v.name == "front")
      (options_.angle == ProjectionAngle::first ? p.pad_above : p.pad_below) = room;
    return p;
  }

  bool is_cut(const std::string& name) const {
    return std::ranges::any_of(views_, [&](const SheetView& v) { return v.cut_in == name; });
  }
  double offset_of_dimension(const std::string& view) const { return dimension_offset + (is_cut(view) ? letters_offset : 0); }

  [[noreturn]] void refuse(const std::vector<ViewToPlace>& places, const PaperFrame& area) const {
    const std::string on = " on " + options_.format.name;
    if (options_.scale) {
      const auto other = lay_out(places, area, sheet_.title_block, options_.angle, {});
      if (other)
        throw InputError("scale: the views have no room" + on + " at " + ratio_text(*options_.scale) + ", expected " +
                         ratio_text(other->scale) + " or less, or a larger sheet");
    }
    throw InputError("page: " + std::to_string(places.size()) + " views have no room" + on +
                     ", expected a larger sheet or fewer views");
  }

  void draw_views() {
    std::vector<Drawing> drawings(views_.size());
    cut_views();
    done_.resize(views_.size());
    seen_edges_.resize(views_.size());
    tbb::parallel_for(std::size_t{0}, views_.size(), [&](std::size_t k) { drawings[k] = drawing_of(k); });
    Drawing& all = sheet_.drawing;
    all.width = options_.format.width;
    all.height = options_.format.height;
    all.scale = sheet_.scale * options_.unit;
    all.pens = Pens(pens_.wide, options_.hidden);
    all.arc_tolerance = options_.fit_arcs;
    if (options_.objects != nullptr && options_.objects->are_told_apart()) all.objects = options_.objects->names;
    for (std::size_t k = 0; k < views_.size(); ++k) {
      append_view(all, drawings[k], views_[k].name);
      if (views_[k].detail != nullptr && drawings[k].polylines.empty())
        sheet_.notes.push_back("detail " + views_[k].label + ": there is no line within its circle");
    }
  }

  SceneView prepared(std::size_t k) const {
    SceneOptions scene;
    scene.coplanar = options_.coplanar;
    scene.hidden_lines = true;  // all that pierces is then found once for all views, which takes less than once for each
    return {scene_, views_[k].view, scene};
  }

  /// All sections before the first is drawn: an object has one hatching in all of them.
  void cut_views() {
    cuts_.resize(views_.size());
    scenes_.resize(views_.size());
    tbb::parallel_for(std::size_t{0}, views_.size(), [&](std::size_t k) {
      if (!views_[k].view.section) return;
      scenes_[k].emplace(prepared(k));
      cuts_[k] = section(*scenes_[k]);
    });
    std::vector<const Section*> sections;
    for (const auto& cut : cuts_)
      if (cut) sections.push_back(&*cut);
    hatching_ = hatching_of(sections);
  }

  Drawing drawing_of(std::size_t k) {
    const SheetView& v = views_[k];
    const PlacedView& placed = sheet_.views[k];
    DrawingOptions o;
    o.page = page();
    o.scale = placed.scale / options_.unit;
    o.unit = options_.unit;
    o.origin_at = placed.origin;
    o.hidden = v.has_hidden_lines ? options_.hidden : HiddenLines::none;
    o.pens = options_.pens;
    o.fit_arcs = v.detail == nullptr ? options_.fit_arcs : 0;
    o.labels = &scene_.labels();
    o.objects = options_.objects;
    o.leave_out_near = true;
    const SceneView scene = scenes_[k] ? *std::move(scenes_[k]) : prepared(k);
    scenes_[k].reset();
    LineOptions line_options = options_.lines;
    if (options_.lines.progress) line_options.progress = [&, k](double done) { show_progress(k, done); };
    const VisibleLines lines = visible_lines(scene, line_options);
    seen_edges_[k] = seen_edges(lines);
    if (cuts_[k]) {
      o.section = &*cuts_[k];
      o.hatching = &hatching_;
      o.section_classes = options_.lines.classes;
    }
    Drawing drawing = draw(scene_.mesh(), v.view, lines, o);
    if (v.detail != nullptr) {
      const Point2 middle = ViewOnPaper(v.view, placed.origin, placed.scale).at(v.detail->at);
      return round_part(drawing, middle, v.detail->radius * placed.scale);
    }
    return drawing;
  }

  /// Views are found side by side, and the function is called by one at a time.
  void show_progress(std::size_t view, double done) {
    const std::lock_guard lock(progress_mutex_);
    done_[view] = done;
    options_.lines.progress(std::accumulate(done_.begin(), done_.end(), 0.0) / static_cast<double>(done_.size()));
  }

  void draw_annotations() {
    Sketch sketch;
    for (std::size_t k = 0; k < views_.size(); ++k) note_cut(views_[k], cuts_[k]);
    if (options_.has_centre_lines) draw_circles(sketch);
    for (std::size_t k = 0; k < views_.size(); ++k) {
      draw_cut(sketch, views_[k]);
      draw_detail(sketch, k);
      const PlacedView& v = sheet_.views[k];
      if (!v.label.empty()) draw_label(sketch, v.label, {(v.box.left + v.box.right) / 2, v.box.top - 4});
    }
    if (options_.has_dimensions) draw_dimensions(sketch);
    draw_frame(sketch, options_.format);
    for (std::string& note : draw_title_block(sketch, sheet_.title_block, options_.title, ratio_text(sheet_.scale),
                                              options_.format.name, options_.angle))
      sheet_.notes.push_back(std::move(note));
    sketch.append_to(sheet_.drawing);
  }

  void note_cut(const SheetView& v, const std::optional<Section>& cut) {
    if (!cut) return;
    if (cut->open_outlines > 0)
      sheet_.notes.push_back("section " + v.label + ": " + std::to_string(cut->open_outlines) +
                             (cut->open_outlines == 1 ? " outline does" : " outlines do") +
                             " not close, so nothing is hatched there: the surface is open");
    else if (cut->caps.empty())
      sheet_.notes.push_back("section " + v.label + ": the plane cuts no closed body");
  }

  void draw_circles(Sketch& sketch) {
    const std::vector<ModelCircle> circles = model_circles(scene_.mesh(), options_.lines.crease);
    if (circles.size() > most_circles) {
      sheet_.notes.push_back("the model has " + std::to_string(circles.size()) +
                             " circles: without centre lines, as more than " + std::to_string(most_circles) +
                             " would hide the drawing");
      return;
    }
    for (std::size_t k = 0; k < views_.size(); ++k) {
      if (views_[k].detail != nullptr || views_[k].name == "iso") continue;
      const PlacedView& v = sheet_.views[k];
      const double reach = (v.box.right - v.box.left + v.box.bottom - v.box.top) / v.scale;
      const ViewOnPaper paper(v.view, v.origin, v.scale);
      std::vector<PaperTrace> traces;
      for (const SheetView& section : views_)
        if (section.cut_in == v.name) traces.push_back(trace_of(paper, section.view));
      const bool shows_hidden = views_[k].has_hidden_lines && options_.hidden != HiddenLines::none;
      std::vector<ModelCircle> shown;
      for (const ModelCircle& c : circles)
        if (shows_hidden || paper.cuts(c) || is_seen(c, seen_edges_[k])) shown.push_back(c);
      draw_centre_lines(sketch, v.name, shown, reach, paper, traces, pens_);
    }
  }

  using Edges = std::vector<std::array<std::uint32_t, 2>>;

  /// Those of which some part is visible.
  Edges seen_edges(const VisibleLines& lines) const {
    Edges edges;
    for (const Line& line : lines.lines) {
      if (line.is_intersection() || line.intervals() == 0 || (line.intervals() == 1 && line.hidden(0))) continue;
      const Edge& edge = scene_.mesh().edges[line.edge];
      edges.push_back({edge.a.value, edge.b.value});
    }
    std::ranges::sort(edges);
    return edges;
  }
  static bool is_seen(const ModelCircle& circle, const Edges& seen) {
    return std::ranges::any_of(circle.edges, [&](const auto& edge) { return std::ranges::binary_search(seen, edge); });
  }

  const PlacedView* placed(const std::string& name) const {
    const auto found = std::ranges::find(sheet_.views, name, &PlacedView::name);
    return found == sheet_.views.end() ? nullptr : &*found;
  }

  /// The trace of a section in the view that sees it edge-on, across the model.
  void draw_cut(Sketch& sketch, const SheetView& section) {
    if (!section.view.section || section.detail != nullptr) return;
    const PlacedView* in = placed(section.cut_in);
    if (in == nullptr) {
      sheet_.notes.push_back("no view of the sheet sees the section " + section.label + " edge-on: without a cutting line");
      return;
    }
    const ViewOnPaper paper(in->view, in->origin, in->scale);
    const PaperTrace trace = trace_of(paper, section.view);
    const Point2 &p = trace.point, &toward = trace.toward;
    const Point2 along = {-toward.y, toward.x};
    // As far as the corners of the box reach along it.
    double first = HUGE_VAL, last = -HUGE_VAL;
    for (const double x : {in->box.left, in->box.right})
      for (const double y : {in->box.top, in->box.bottom}) {
        const double t = (x - p.x) * along.x + (y - p.y) * along.y;
        first = std::min(first, t);
        last = std::max(last, t);
      }
    constexpr double over = 7;
    const auto at = [&](double t) { return Point2{p.x + t * along.x, p.y + t * along.y}; };
    draw_cutting_line(sketch, section.name.substr(0, section.name.find('-')), at(first - over), at(last + over), toward, pens_);
  }

  void draw_detail(Sketch& sketch, std::size_t k) {
    const SheetDetail* const detail = views_[k].detail;
    if (detail == nullptr) return;
    const std::string letter = views_[k].label.substr(0, views_[k].label.find(' '));
    const auto layer = sketch.layer("details", continuous_pen(pens_.narrow()));
    const auto circle = [&](const PlacedView& v) {
      const Point2 middle = ViewOnPaper(v.view, v.origin, v.scale).at(detail->at);
      const double radius = detail->radius * v.scale;
      sketch.circle(layer, middle, radius);
      return std::pair{middle, radius};
    };
    const PlacedView& in = *placed(detail->view);
    const auto [middle, radius] = circle(in);
    draw_letter(sketch, layer, letter, in, middle, radius);
    circle(sheet_.views[k]);
  }

  /// Of a detail, beside its circle where no line of the view is, or else beside the view, with a line that leads there.
  void draw_letter(Sketch& sketch, Sketch::LayerIndex layer, const std::string& letter, const PlacedView& in,
                   const Point2& middle, double radius) {
    const double wide = StrokeFont(label_letters).width(letter);
    constexpr double high = label_letters, beside = 1;
    for (const auto& [x, y] : {std::pair{1, -1}, {1, 1}, {-1, -1}, {-1, 1}}) {
      const double across = radius * 0.75 + beside;
      const Point2 corner = {middle.x + x * across, middle.y + y * across};
      const Point2 at = {x > 0 ? corner.x : corner.x - wide, y > 0 ? corner.y + high : corner.y};
      if (!is_free(sheet_.drawing, in.name, {at.x - beside, at.y - high - beside, at.x + wide + beside, at.y + beside}))
        continue;
      sketch.text("details", letter, label_letters, at);
      return;
    }
    const Point2 at = {in.box.right + 4, middle.y + high / 2};
    sketch.line(layer, {middle.x + radius, middle.y}, {at.x - beside, middle.y});
    sketch.text("details", letter, label_letters, at);
  }

  void draw_dimensions(Sketch& sketch) {
    const PlacedView *front = placed("front"), *top = placed("top");
    const bool first = options_.angle == ProjectionAngle::first;
    if (front != nullptr) {
      const PaperFrame& b = front->box;
      const double offset = offset_of_dimension("front");
      const double y = first ? b.top - offset : b.bottom + offset, from = first ? b.top : b.bottom;
      add_dimension(sketch, *front, {b.left, from}, {b.right, from}, {b.left, y}, {b.right, y});
      const double x = b.left - offset;
      add_dimension(sketch, *front, {b.left, b.bottom}, {b.left, b.top}, {x, b.bottom}, {x, b.top});
    }
    if (top != nullptr) {
      const PaperFrame& b = top->box;
      const double x = b.left - offset_of_dimension("top");
      add_dimension(sketch, *top, {b.left, b.bottom}, {b.left, b.top}, {x, b.bottom}, {x, b.top});
    }
  }

  /// @param from, to points of the view's box @param a, b the ends of the arrows
  void add_dimension(Sketch& sketch, const PlacedView& v, const Point2& from, const Point2& to, const Point2& a,
                     const Point2& b) {
    const Frame& f = v.view.frame;
    const auto in_space = [&](const Point2& p) {
      const double x = (p.x - v.origin.x) / v.scale, y = (v.origin.y - p.y) / v.scale;
      return Point3{f.origin.x + x * f.right.x + y * f.up.x, f.origin.y + x * f.right.y + y * f.up.y,
                    f.origin.z + x * f.right.z + y * f.up.z};
    };
    const double length = std::hypot(to.x - from.x, to.y - from.y) / v.scale * options_.unit;
    if (!(length > 0)) return;
    const std::string text = number_text(length);
    draw_dimension(sketch, {from, to, a, b, text}, pens_);
    sheet_.dimensions.push_back({v.name, text, {in_space(from), in_space(to)}, {a, b}});
  }

  const Scene& scene_;
  const SheetOptions& options_;
  std::vector<SheetView> views_;
  std::vector<std::optional<Section>> cuts_;      // by view
  std::vector<std::optional<SceneView>> scenes_;  // by view, of those that are cut, until they are drawn
  ObjectHatching hatching_;
  std::vector<Edges> seen_edges_;  // by view, ascending
  std::mutex progress_mutex_;
  std::vector<double> done_;  // by view
  SheetPens pens_;
  Sheet sheet_;
};

}  // namespace

Sheet draw_sheet(const Scene& scene, const SheetOptions& options) { return SheetMaker(scene, options).sheet(); }

}  // namespace hsr
