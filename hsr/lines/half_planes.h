#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/predicates.h"
#include "hsr/lines/crease.h"
#include "hsr/scene/edge_mark_table.h"
#include "hsr/scene/projected_mesh.h"
#include "hsr/scene/tie_rule.h"

namespace hsr::internal {

/// Where the points of one face, or of several that coincide, lie arbitrarily near a part of an edge: the half-plane that starts
/// at the edge and contains the apex.
struct HalfPlane {
  TriangleId triangle;  ///< one that lies in it
  VertexId apex;        ///< a corner of that, off the line of the edge
  Sign side;            ///< of the edge's view plane: positive, to the left of a -> b; zero: seen edge-on
  /// Seen edge-on: whether it starts toward the eye. An edge that is seen as a point has none that do.
  bool is_front = false;
  FaceId face;                          ///< the one that is on top of those that coincide in it
  std::vector<FaceId> coincident = {};  ///< these, ascending; empty: there is one
  bool is_contact = false;              ///< bodies touch in it (mark_contacts)

  std::size_t faces() const { return coincident.empty() ? 1 : coincident.size(); }
};

/// A triangle that contains a part of an edge, and is not at it.
struct EdgeContact {
  TriangleId triangle;
  std::size_t along = 3;  ///< the side of the triangle along which the edge runs; 3: through the inside
};

/// The half-planes along a part of an edge, each once. One object for each part and thread.
class HalfPlanes {
 public:
  virtual ~HalfPlanes() = default;
  HalfPlanes(const HalfPlanes&) = delete;
  HalfPlanes& operator=(const HalfPlanes&) = delete;

  const std::vector<HalfPlane>& all() const { return all_; }
  std::vector<HalfPlane>& all() { return all_; }

  /// The marks of edges that run along the part.
  const std::vector<MarkOfObject>& marks() const { return marks_; }
  void add_marks(std::span<const MarkOfObject> marks) { marks_.insert(marks_.end(), marks.begin(), marks.end()); }

  /// On which side of the plane of one of them another starts; zero: both are in one plane.
  virtual Sign side(const HalfPlane& plane, const HalfPlane& other) const = 0;
  /// Whether x hides y just beside the edge. @pre both are on one side of the view plane
  virtual bool is_nearer(const HalfPlane& x, const HalfPlane& y) const = 0;
  /// By how many degrees two deviate from one plane: 0 ... 180.
  virtual double deviation_from_flat(const HalfPlane& x, const HalfPlane& y) const = 0;

 protected:
  explicit HalfPlanes(TieRule ties) : ties_(ties) {}

  const TieRule& ties() const { return ties_; }

  /// Another face in a half-plane that is known.
  void share(HalfPlane& known, FaceId other) const {
    if (known.coincident.empty()) known.coincident.push_back(known.face);
    known.coincident.insert(std::upper_bound(known.coincident.begin(), known.coincident.end(), other), other);
    if (ties_.is_above(other, known.face)) known.face = other;
  }

  std::vector<HalfPlane> all_;

 private:
  std::vector<MarkOfObject> marks_;
  TieRule ties_;
};

/// The half-planes of the faces that contain the part, told apart exactly.
/// Cost: O(m^2) signs of degree 3 for m faces at the part, nearly always m = 2.
class ExactHalfPlanes : public HalfPlanes {
 public:
  ExactHalfPlanes(const ProjectedMesh& projected, Predicates& exact, const Edge& edge)
      : HalfPlanes(projected.ties()), projected_(projected), exact_(exact), edge_(edge) {}

  HalfPlane half_of(TriangleId at_edge) const {
    return {at_edge, projected_.mesh().apex(at_edge, edge_), projected_.side_of_edge(at_edge, edge_), false,
            projected_.mesh().face_of[at_edge]};
  }
  /// A triangle that has the edge as its own.
  void add(TriangleId at_edge) { add(half_of(at_edge)); }
  /// The halves of a triangle that the edge runs through, or the one that begins along its side.
  void add(const EdgeContact& contact) {
    for_each_half(contact, [&](const HalfPlane& h) { add(h); });
  }
  /// The half-planes of a contact, as yet with that face only: calls f(half-plane).
  void for_each_half(const EdgeContact& contact, const std::function<void(const HalfPlane&)>& f) const;
  /// Adds one with all the faces that coincide in it, ascending. @pre no other coincides with it
  void add(HalfPlane half_plane, std::span<const FaceId> faces);
  /// Which of all coincides with another half-plane; if none does that is added.
  std::size_t place(const HalfPlane& other);

  Sign side(const HalfPlane& plane, const HalfPlane& other) const override {
    return exact_.side(projected_.face_plane(plane.triangle), projected_.point(other.apex));
  }
  bool is_nearer(const HalfPlane& x, const HalfPlane& y) const override {
    // The eye lies on the side `facing` of a triangle's plane, and what is farther on the other.
    return side(x, y) * projected_.facing(x.triangle) == Sign::negative;
  }
  double deviation_from_flat(const HalfPlane& x, const HalfPlane& y) const override {
    return internal::deviation_from_flat(projected_, edge_, x.apex, y.apex);
  }

 private:
  void add(const HalfPlane& added);
  bool coincide(const HalfPlane& x, const HalfPlane& y) const;
  bool starts_toward_eye(const HalfPlane& edge_on) const;

  const ProjectedMesh& projected_;
  Predicates& exact_;
  const Edge& edge_;
};

}  // namespace hsr::internal
