#include "hsr/surfaces/edge_on_caps.h"

#include <algorithm>
#include <utility>

#include "hsr/scene/view_parts.h"
#include "hsr/surfaces/cutting_planes.h"

namespace hsr::internal {

namespace {

using Place = std::array<Rational, 2>;

/// A segment that is seen on the plane's line, from the lower end in the image to the upper one.
struct SeenSegment {
  std::array<Place, 2> places;
  std::array<RationalVector, 2> ends;
  std::uint32_t object;
  FaceId face;
};

class EdgeOnCaps {
 public:
  explicit EdgeOnCaps(const SceneView& scene)
      : scene_(scene),
        mesh_(scene.mesh()),
        view_(scene.view()),
        projected_(scene.parts().projected()),
        exact_(projected_.predicates()),
        image_(view_) {}

  std::vector<SectionLine> lines() {
    for (std::size_t number = 1; number <= view_.planes.size(); ++number) {
      const auto k = static_cast<std::uint8_t>(number);
      segments_.clear();
      const Plane plane = projected_.cutting_plane(k);
      for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) add_cut(plane, k, TriangleId(t));
      unite();
    }
    return std::move(lines_);
  }

 private:
  /// Of a triangle some corners stay and some go.
  void add_cut(const Plane& plane, std::uint8_t k, TriangleId t) {
    const auto& c = mesh_.triangles[t];
    std::array<Sign, 3> at;
    for (std::size_t i = 0; i < 3; ++i) at[i] = projected_.side(plane, c[i], exact_);
    std::vector<RationalVector> ends;
    const CuttingPlane cutter = cutting_plane(view_.planes[k - 1U]);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      if ((at[i] == Sign::negative) == (at[j] == Sign::negative)) continue;
      const std::size_t low = std::min(c[i], c[j]) == c[i] ? i : j, high = low == i ? j : i;
      RationalVector p = rational(mesh_.points[c[low]]), q = rational(mesh_.points[c[high]]);
      const Rational a = cutter.at(p), share = a / (a - cutter.at(q));
      for (std::size_t axis = 0; axis < 3; ++axis) p[axis] = p[axis] + share * (q[axis] - p[axis]);
      ends.push_back(p);
    }
    if (ends.size() != 2 || !keep_seen(k, ends[0], ends[1])) return;
    SeenSegment seen{{image_(ends[0]), image_(ends[1])}, {ends[0], ends[1]}, 0, mesh_.face_of[t]};
    if (seen.places[0] == seen.places[1]) return;
    if (seen.places[1] < seen.places[0]) {
      std::swap(seen.places[0], seen.places[1]);
      std::swap(seen.ends[0], seen.ends[1]);
    }
    if (!scene_.labels().object.empty()) seen.object = scene_.labels().object[seen.face.value];
    segments_.push_back(std::move(seen));
  }
  /// Beyond the near plane, before the far one, and where the other planes take the rest away.
  bool keep_seen(std::uint8_t k, RationalVector& from, RationalVector& to) const {
    if (view_.is_perspective()) {
      const RationalVector eye = rational(view_.viewpoint.at), axis = minus(rational(view_.target), eye);
      const Rational offset = -dot(axis, eye) - Rational(view_.near) * dot(axis, axis);
      if (!keep({axis, offset}, from, to)) return false;
    }
    if (view_.far && !keep(before_far(view_), from, to)) return false;
    for (std::size_t number = 1; number <= view_.planes.size(); ++number) {
      const auto other = static_cast<std::uint8_t>(number);
      if (other == k) continue;
      const CuttingPlane cutter = cutting_plane_of(view_, {other, other, Sign::negative});
      // The same plane, with the other side left: between the two nothing is taken away.
      if (cutter.at(from).sign() == Sign::zero && cutter.at(to).sign() == Sign::zero) return false;
      if (!keep(cutter, from, to)) return false;
    }
    return from != to;
  }

  void unite() {
    std::sort(segments_.begin(), segments_.end(), [](const SeenSegment& x, const SeenSegment& y) {
      return x.object != y.object ? x.object < y.object : x.places < y.places;
    });
    std::vector<SeenSegment> done;  // disjoint, by place
    for (auto first = segments_.begin(); first != segments_.end();) {
      const auto end = std::find_if(first, segments_.end(), [&](const SeenSegment& s) { return s.object != first->object; });
      std::vector<SeenSegment> own;
      for (; first != end; ++first) {
        if (own.empty() || own.back().places[1] < first->places[0]) {
          own.push_back(*first);
        } else if (own.back().places[1] < first->places[1]) {
          own.back().places[1] = first->places[1];
          own.back().ends[1] = first->ends[1];
        }
      }
      std::vector<SeenSegment> rest;
      for (const SeenSegment& one : own) add_rest(one, done, rest);
      done.insert(done.end(), rest.begin(), rest.end());
      std::sort(done.begin(), done.end(), [](const SeenSegment& x, const SeenSegment& y) { return x.places < y.places; });
    }
    for (const SeenSegment& s : done) lines_.push_back({s.ends, EdgeClass::section, {s.object, SectionLine::none}, s.face});
  }
  /// What of it is nowhere in those that are done.
  static void add_rest(SeenSegment one, const std::vector<SeenSegment>& done, std::vector<SeenSegment>& rest) {
    for (const SeenSegment& other : done) {
      if (!(other.places[0] < one.places[1])) break;
      if (!(one.places[0] < other.places[1])) continue;
      if (one.places[0] < other.places[0]) {
        SeenSegment part = one;
        part.places[1] = other.places[0];
        part.ends[1] = other.ends[0];
        rest.push_back(part);
      }
      one.places[0] = other.places[1];
      one.ends[0] = other.ends[1];
      if (!(one.places[0] < one.places[1])) return;
    }
    rest.push_back(std::move(one));
  }

  const SceneView& scene_;
  const Mesh& mesh_;
  const View& view_;
  const ProjectedMesh& projected_;
  Predicates exact_;
  PaperImage image_;
  std::vector<SeenSegment> segments_;
  std::vector<SectionLine> lines_;
};

}  // namespace

std::vector<SectionLine> edge_on_cap_lines(const SceneView& scene) {
  const View& view = scene.view();
  const bool are_all_edge_on = std::all_of(view.planes.begin(), view.planes.end(),
                                           [&](const SectionPlane& plane) { return viewer_side(view, plane) == Sign::zero; });
  if (view.planes.empty() || !are_all_edge_on) return {};
  return EdgeOnCaps(scene).lines();
}

}  // namespace hsr::internal
