#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/point.h"
#include "geometry/ragged.h"
#include "hsr/drawing/ellipse_arc.h"
#include "hsr/drawing/page.h"
#include "hsr/drawing/pens.h"
#include "hsr/face_labels.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/surfaces/regions.h"
#include "hsr/surfaces/section.h"

namespace hsr {

/// How the objects of a scene are hatched in all drawings of it, by object.
struct ObjectHatching {
  std::map<std::uint32_t, std::uint32_t>
      style;  ///< the direction and the phase; objects that touch in a section have different ones
  std::map<std::uint32_t, double> thickness;  ///< of its thickest cap, in units of the model
};

struct DrawingOptions {
  Page page = {};
  std::optional<double> scale = {};  ///< paper length over model length; nothing: fit
  /// Without `scale`: the largest of ISO 5455 that fits: 1:1, 1:2, 1:5, 1:10, ..., 2:1, 5:1, 10:1, ...
  bool standard_scale = false;
  /// No page and no fitting: points are those of the view's frame, its origin at (0, 0), y down. `scale` and `unit` are passed over:
  /// Drawing::scale is the power of ten that makes the drawing 1000 to 10 000 "mm" large, and min_length is in units of the frame.
  bool in_frame_units = false;
  double unit = 1;  ///< millimetres in a model unit
  /// Where on the page, in mm, the origin of the view's frame is, at `scale`, so that several views line up; the page is not turned, and
  /// nothing is centred or fitted. Nothing: the drawing is centred.
  std::optional<Point2> origin_at = {};
  HiddenLines hidden = HiddenLines::none;
  std::vector<PenSetting> pens = {};  ///< other than ISO 128's for that page: see line_group()
  /// Degrees across the shorter side of the picture, perspective only: the picture is cut to a frame around the target with the
  /// proportions of the page less its margins. Nothing: all that is beyond the near plane.
  std::optional<double> field_of_view = {};
  Arithmetic arithmetic = Arithmetic::staged;  ///< double_only is taken as staged
  /// Last, on the written coordinates: also leave out what runs within 0.01 mm of a stronger line; see near_lines.h.
  bool leave_out_near = false;
  /// Last of all: lines in an order for pen plotters; see pen_order.h.
  bool sort_for_pen = false;
  /// With regions: instead of lines and fills their rings, as closed outlines.
  bool outline_only = false;
  /// Millimetres: lines that are joined to one another and together shorter than this are left out, such as freckles on scans.
  double min_length = 0;
  /// Millimetres, in_frame_units: of the frame; 0: none. Runs of lines that lie on one circle in space, within this, become arcs: see
  /// fit_arcs.h. Fills keep the lines of their faces.
  double fit_arcs = 0;
  /// With fit_arcs: edges that its marks say lie on one circle become arcs of that very circle, be they ever so few. nullptr: nothing
  /// is known.
  const FaceLabels* labels = nullptr;
  /// The caps of the view's section: their borders and hatching lie over all lines, and with regions their faces over all fills.
  /// nullptr: none.
  const Section* section = nullptr;
  EdgeClasses section_classes = drawn_classes;  ///< which of these are drawn
  std::vector<Colour> cap_colours = {};         ///< by cap; empty: white
  double hatch_scale = 1;  ///< with in_frame_units: millimetres of paper to a unit of the frame, for the hatching
  const ObjectHatching* hatching = nullptr;  ///< where several drawings are of one scene; nullptr: as `section` has it
  /// Lines and fills of different objects stay apart; nullptr, or fewer than two: they are not told apart.
  const SceneObjects* objects = nullptr;
};

/// Some lines of one style, joined end to end.
struct Polyline {
  bool hidden = false, closed = false;  ///< closed: the last point is joined to the first, which is not repeated
  EdgeClass edge_class = EdgeClass::outline;
  std::uint32_t first_point = 0, end_point = 0, first_edge = 0, end_edge = 0, first_face = 0, end_face = 0;
  std::uint32_t first_arc = 0, end_arc = 0;
  std::uint32_t object = SceneObjects::none;  ///< of Drawing::objects; none: of several
};

/// Lines of a polyline that are drawn as one arc: from the point first_line of Drawing::points to the point end_line, which is the
/// first of the polyline where that is closed and ends there.
struct DrawnArc {
  std::uint32_t first_line = 0, end_line = 0;
  EllipseArc ellipse;
};

/// A part of the page in one colour.
struct Fill {
  Colour colour = {};       ///< its own opacity is part of the next
  double opacity = 1;       ///< more than 0, at most 1
  std::uint32_t layer = 0;  ///< of what is seen through: fills of one layer do not overlap, and one opacity makes them a sheet
  std::uint32_t first_ring = 0, end_ring = 0, first_face = 0, end_face = 0;
  std::uint32_t object = SceneObjects::none;  ///< of Drawing::objects; none: of several
};

/// A line that is painted between fills: of a painting in which one is seen through another.
struct FillLine {
  std::uint32_t fills_before = 0;  ///< how many fills are painted before it
  bool closed = false;
  EdgeClass edge_class = EdgeClass::outline;
  std::uint32_t first_point = 0, end_point = 0;
};

/// The filled parts of a drawing, painted in turn, each by the nonzero rule. One may reach beneath those that are painted later, so
/// that no seam shows between them.
struct Fills {
  std::vector<Fill> fills;
  Ragged<PaperPoint> rings;
  std::vector<std::uint32_t> faces;
  std::vector<FillLine> lines;  ///< as they are painted
  std::vector<PaperPoint> line_points;

  std::span<const PaperPoint> points_of(const FillLine& l) const {
    return {line_points.data() + l.first_point, line_points.data() + l.end_point};
  }
};

/// Some polylines in a row that have a name and a pen of their own, on a page of several views.
struct NamedLayer {
  std::string name;  ///< lower-case words and digits, blanks between: "front visible outline"
  Pen pen;
  std::uint32_t first_polyline = 0, end_polyline = 0;
};

/// Polylines on a page, each point of the image drawn once.
struct Drawing {
  double width = 210, height = 297;  ///< of the page, mm
  double scale = 1;                  ///< millimetres of paper to a unit of the view's frame; 0 or infinite beyond a double
  bool fits = true;                  ///< nothing is outside the page
  Pens pens = Pens();

  std::vector<std::string> objects;                 ///< names; empty: fewer than two are told apart
  std::vector<Polyline> polylines;                  ///< hidden before visible, then by class, object and their first edge
  std::vector<NamedLayer> layers;                   ///< in turn, all polylines; empty: one for each visibility and class
  std::vector<PaperPoint> points;                   ///< x to the right, y down, from the upper left corner of the page
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< i < j, ascending and unique for each polyline
  std::vector<std::uint32_t> faces;                 ///< ascending and unique for each polyline
  std::vector<DrawnArc> arcs;                       ///< ascending; polylines have the points of their lines all the same
  double arc_tolerance = 0;                         ///< mm: how far arcs are from the lines they stand for, at most

  Fills fills;  ///< under the lines

  /// Parts of edges that were left out where another one is drawn, wholly or in part.
  std::uint64_t visible_under_visible = 0, hidden_under_visible = 0, hidden_under_hidden = 0;
  std::uint64_t near_coincident = 0;  ///< lines left out within 0.01 mm of a stronger one, wholly or in part
  std::uint64_t merged = 0;           ///< joints between collinear parts that became one line
  std::uint64_t short_dropped = 0;    ///< joined lines under 0.01 mm
  std::uint64_t groups_dropped = 0;   ///< joined lines in groups under DrawingOptions::min_length
  DecisionCounts decisions;

  std::span<const PaperPoint> points_of(const Polyline& p) const {
    return {points.data() + p.first_point, points.data() + p.end_point};
  }
  std::span<const std::array<std::uint32_t, 2>> edges_of(const Polyline& p) const {
    return {edges.data() + p.first_edge, edges.data() + p.end_edge};
  }
  std::span<const std::uint32_t> faces_of(const Polyline& p) const {
    return {faces.data() + p.first_face, faces.data() + p.end_face};
  }
  std::span<const DrawnArc> arcs_of(const Polyline& p) const { return {arcs.data() + p.first_arc, arcs.data() + p.end_arc}; }
};

/// The picture that the field of view cuts out, for LineOptions::frame; nothing where there is none.
/// @throws InputError as draw() does
std::optional<FrameSize> frame_size(const View& view, const DrawingOptions& options);

/// The lines on paper: no image point twice, collinear parts merged, parts of one style joined into long polylines.
///
///   (1) what is drawn visible is the union of the visible parts; what is drawn hidden, of the hidden parts less that union
///   (2) where visible parts of several classes coincide, the first of outline, boundary, sharp, intersection, wire, smooth is
///       drawn
///   (3) a coordinate is the exact one rounded to 0.001 mm, halves away from zero; except where the field of view cuts a line
///   (4) the same for any number of threads
///
/// With leave_out_near, less what it leaves out.
/// Fit: the box around all lines, drawn hidden ones or not, fills the page less its margins; so --hidden changes no place.
/// @throws InputError if the field of view is not within (0, 180), the margin takes the page, a line lies beyond 1e9 mm, or there is
/// more than 32 bits count
/// Exact: yes. Cost: O(n log n), and an exact rational point for each end that coincides with one of another edge in mid-edge.
/// @param regions what is filled, or nullptr
Drawing draw(const Mesh& mesh, const View& view, const VisibleLines& lines, const DrawingOptions& options = {},
             const Regions* regions = nullptr);

}  // namespace hsr
