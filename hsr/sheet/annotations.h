#pragma once

#include <string>
#include <vector>

#include "hsr/sheet/model_circles.h"
#include "hsr/sheet/sketch.h"
#include "hsr/view/view.h"

namespace hsr::internal {

/// From the model to the paper of one view that stands on a sheet: a choice of what is drawn, in doubles.
class ViewOnPaper {
 public:
  /// @param origin where the frame's origin is, mm @param scale mm to a unit of the model
  ViewOnPaper(const View& view, const Point2& origin, double scale) : view_(view), origin_(origin), scale_(scale) {}

  Point2 at(const Point3& p) const;
  Point2 along(const Point3& direction) const;  ///< its image, mm for a direction of length 1
  /// Whether the view's section cuts a circle.
  bool cuts(const ModelCircle& circle) const;
  double scale() const { return scale_; }
  const View& view() const { return view_; }

 private:
  const View& view_;
  Point2 origin_;
  double scale_;
};

/// Widths of the lines of a sheet, mm.
struct SheetPens {
  double wide = 0.5;
  double narrow() const { return wide / 2; }
};

/// A plane that a view sees edge-on.
struct PaperTrace {
  Point2 point;   ///< mm
  Point2 toward;  ///< square to it, of length 1
};

/// The trace of a view's section in another view. @pre this sees it edge-on
PaperTrace trace_of(const ViewOnPaper& paper, const View& section);

/// Centre lines of the circles that are seen as circles, and the axes of those that are seen edge-on (ISO 128-24, 04.1): chains that
/// reach 3 mm beyond, and cross in dashes.
/// @param circles those that are to be seen in the view, or that its section cuts @param reach of the model @param traces of sections: their cutting lines stand for the centre lines along them
void draw_centre_lines(Sketch& sketch, const std::string& view_name, const std::vector<ModelCircle>& circles, double reach,
                       const ViewOnPaper& view, const std::vector<PaperTrace>& traces, const SheetPens& pens);

/// A dimension on a sheet: its line, parallel to the line from one of its points to the other, and what it says.
struct DimensionLine {
  Point2 from, to;            ///< mm: the points that are dimensioned
  Point2 line_from, line_to;  ///< mm: the ends of the dimension line
  std::string text;
};

/// Extension lines, the line with arrows, and the text over it; arrows from outside where there is no room (ISO 129-1).
void draw_dimension(Sketch& sketch, const DimensionLine& dimension, const SheetPens& pens);

/// The trace of a section in a view: a chain with thick ends, arrows in the direction of sight, and letters (ISO 128-40).
/// @param toward of length 1, where the viewer of the section looks
void draw_cutting_line(Sketch& sketch, const std::string& letter, const Point2& from, const Point2& to, const Point2& toward,
                       const SheetPens& pens);

/// The letters over a section or a detail.
void draw_label(Sketch& sketch, const std::string& text, const Point2& at);

constexpr double dimension_letters = 3.5, label_letters = 5;  // mm

}  // namespace hsr::internal
