#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "hsr/io/write/dxf_tables.h"
#include "hsr/io/write/path.h"

namespace hsr::internal {

/// From thousandths of the drawing to units of the model.
class ModelUnits {
 public:
  explicit ModelUnits(double scale);
  /// Of a power of ten, or another scale that has a whole number of thousandths, one rounding: the double nearest to the number.
  double operator()(std::int64_t thousandths) const {
    const auto x = static_cast<double>(thousandths);
    return is_large_ ? x / factor_ : x * factor_;
  }
  double of_millimetres(double mm) const;  ///< of the drawing, rounded to its thousandths first

 private:
  bool is_large_;
  double factor_;
};

/// Writes the lines of a drawing as entities: LINE, and POLYLINE or LWPOLYLINE; arcs of circles as CIRCLE and ARC, or, beside other
/// parts of a line, as bulges of its polyline; those of ellipses as ELLIPSE, or in release 12, which has none, as short lines within a
/// tenth of the tolerance.
class DxfEntities {
 public:
  DxfEntities(DxfText& out, const Drawing& drawing, const ModelUnits& units, std::uint64_t owner, double page_scale)
      : out_(out), drawing_(drawing), units_(units), owner_(owner), page_scale_(page_scale) {}

  void append(const Polyline& p, const Layer& of);

 private:
  /// A point of a polyline, and how far what follows bends: the tangent of a quarter of its angle, counter-clockwise.
  struct Corner {
    PaperPoint at;
    double bulge = 0;
  };

  void begin(const char* type, const char* subclass);
  void add_point(const PaperPoint& p, int code = 10) { out_.add_point(units_(p.x), -units_(p.y), code); }
  std::int64_t flags(std::span<const Corner> corners, bool closed) const;
  void add_dash_scale(const PaperPoint& from, const PaperPoint& to);
  void append_line(const PaperPoint& from, const PaperPoint& to);
  void append_polyline(std::span<const Corner> corners, bool closed);
  void append_arc(const EllipseArc& arc);
  void append_ellipse(const EllipseArc& arc);
  void append_path(const Path& path);
  void append_run(std::span<const PathPart> parts, bool closed);
  void append_provenance();

  DxfText& out_;
  const Drawing& drawing_;
  const ModelUnits& units_;
  std::uint64_t owner_;
  double page_scale_;
  // Of the line at hand.
  const Polyline* polyline_ = nullptr;
  const Pen* pen_ = nullptr;
  std::string layer_;
};

}  // namespace hsr::internal
