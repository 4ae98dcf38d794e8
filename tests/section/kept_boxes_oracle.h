#pragma once

#include <array>
#include <vector>

#include "geometry/rational_vector.h"
#include "hsr/view/view.h"
#include "tests/section/cut_boxes.h"

namespace hsr {

/// What several planes leave of boxes, told point by point: along each line of sight what is left begins where the first of the planes is
/// met. Knows no cells, no symbols and no doubles.
class KeptBoxesOracle {
 public:
  KeptBoxesOracle(const CutBoxes& boxes, const View& view);

  /// Whether the point is left.
  bool is_kept(const internal::RationalVector& p) const;
  /// Whether a face or a cap hides it. @pre it is kept
  bool is_hidden(const internal::RationalVector& p) const;
  /// Whether who looks the other way from where what is left begins sees the point, which is taken away. @pre a parallel view
  bool is_seen_from_cut(const internal::RationalVector& p) const;
  /// Between two of these, ascending from 0 to 1, the points of the way from a to b are all alike.
  std::vector<Rational> changes(const internal::RationalVector& a, const internal::RationalVector& b) const;

  /// What the line of sight through a point shows: a face, by number; a cap; or nothing.
  struct Seen {
    enum class Kind { nothing, face, cap } kind = Kind::nothing;
    std::uint32_t face = 0;
  };
  /// @param p off the lines in which anything changes, and in front of the eye
  Seen seen(const internal::RationalVector& p) const;

 private:
  struct Box {
    internal::RationalVector low, high;
  };
  /// An affine function of places: positive beyond the planes that it is of.
  struct Value {
    internal::RationalVector gradient;
    Rational offset;
    Rational at(const internal::RationalVector& p) const { return internal::dot(gradient, p) + offset; }
  };
  /// A part of a line of sight, toward the viewer, in shares of the way; without an end.
  struct Part {
    Rational from, to;
    bool is_endless = false, is_empty = false;
  };

  internal::RationalVector toward(const internal::RationalVector& p) const;
  internal::RationalVector on_sight(const internal::RationalVector& p, const Rational& s) const;
  Rational at_eye(const Value& v) const;
  bool is_in_face(const internal::RationalVector& p, const Rational& from, const Rational& to) const;
  std::vector<Part> kept_parts(const internal::RationalVector& p) const;
  bool is_capped(const internal::RationalVector& p) const;
  bool has_cap(const Box& box, const Value& plane) const;
  /// The plane of the viewpoint and of the line in which two others meet.
  Value through_eye(const Value& a, const Value& b) const;

  std::vector<Box> boxes_;
  View view_;
  std::vector<Value> facing_, edge_on_;
  std::vector<Value> far_;  // at most one
};

}  // namespace hsr
