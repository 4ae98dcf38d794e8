#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "hsr/drawing/drawing.h"
#include "hsr/scene/scene.h"

namespace hsr {

/// A sheet of drawing paper: A0 ... A4 of ISO 5457, A4 upright and the others lying, or A and B of ANSI.
struct SheetFormat {
  std::string name = "A3";
  double width = 420, height = 297;  ///< mm, trimmed
  double filing_margin = 20;         ///< mm, on the left, from the edge of the sheet to the frame
  double margin = 10;                ///< mm, on the other sides
  bool has_full_grid = true;         ///< fields of the grid on all sides; else at the top and on the right

  PaperFrame frame() const { return {filing_margin, margin, width - margin, height - margin}; }
};

/// "A0" ... "A4", "ANSI-A" or "ANSI-B". @throws InputError for anything else
SheetFormat sheet_format(const std::string& name);

/// First: a view stands on the other side of the front view than it is seen from, the view from above beneath it; third: on the same side
/// (ISO 5456-2).
enum class ProjectionAngle : unsigned char { first, third };

/// What the title block says (ISO 7200); any text in UTF-8, empty fields stay empty.
struct TitleBlock {
  std::string owner, title, subtitle, number, creator, approver, document_type, material, date, revision, language, sheet;
};

/// A part of a view that is drawn again, larger.
struct SheetDetail {
  std::string view = {};  ///< front, side, top or iso
  Point3 at = {};         ///< in its middle
  double radius = 0;      ///< units of the model
  double scale = 1;       ///< paper length over model length
};

struct SheetOptions {
  SheetFormat format = {};
  ProjectionAngle angle = ProjectionAngle::first;
  std::optional<double> scale =
      {};             ///< paper length over model length, of all views but details; nothing: the largest of ISO 5455 that fits
  double unit = 1;    ///< millimetres in a model unit
  bool y_up = false;  ///< the views are those of a model with Y up
  std::vector<std::string> views = {"front", "top", "side", "iso"};  ///< which of these
  /// Each is drawn in a view of its own, A-A, B-B, ..., and as a cutting line in the view that sees it edge-on.
  std::vector<SectionPlane> sections = {};
  std::vector<SheetDetail> details = {};
  TitleBlock title = {};
  bool has_dimensions = true, has_centre_lines = true;
  LineOptions lines = {};  ///< of each view
  /// Of front, top and side; sections, details of them and the iso view have none.
  HiddenLines hidden = HiddenLines::dashed;
  Coplanar coplanar = Coplanar::first;
  std::vector<PenSetting> pens = {};
  double fit_arcs = 0;  ///< as DrawingOptions
  const SceneObjects* objects = nullptr;
};

/// A view that stands on a sheet: the point p of the model is at origin + scale (right . (p - o), -up . (p - o)), where o, right and up
/// are the view's frame.
struct PlacedView {
  std::string name;   ///< of its layers: front, top, side, iso, A-A, detail B
  std::string label;  ///< what is written over it; empty: nothing
  View view;
  Point2 origin;     ///< mm, y down from the upper left corner
  double scale = 1;  ///< mm to a unit of the model
  PaperFrame box;    ///< what the model covers
};

/// An overall dimension, in space and on paper.
struct PlacedDimension {
  std::string view, text;
  std::array<Point3, 2> points;
  std::array<Point2, 2> line;  ///< mm: the ends of its arrows
};

struct Sheet {
  Drawing drawing;   ///< a page with named layers: each view's lines, then what is drawn around them
  double scale = 1;  ///< paper length over model length
  std::vector<PlacedView> views;
  std::vector<PlacedDimension> dimensions;
  PaperFrame frame, title_block;
  std::vector<std::string> notes;  ///< what could not be drawn, one line each
};

/// A drawing sheet: several views of a scene side by side in one scale, in first or third angle (ISO 5456-2), within a frame with a title
/// block. The views share the scene; what is common to them is found once.
///
/// What is visible is exact as in visible_lines(); where things are placed, centre lines of circles and dimensions are in doubles.
/// @throws InputError where the views do not fit on the sheet at the scale, a view is unknown, or a section or detail is no such
/// Cost: that of visible_lines() and draw() of each view.
Sheet draw_sheet(const Scene& scene, const SheetOptions& options);

}  // namespace hsr
