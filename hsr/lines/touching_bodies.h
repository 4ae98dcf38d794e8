#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "geometry/mesh.h"
#include "hsr/lines/half_planes.h"

namespace hsr::internal {

/// What the numbers of faces in the half-planes around a part of an edge tell.
enum class Touching : std::uint8_t {
  nothing,  ///< no faces coincide
  bodies,   ///< bodies touch in some of the half-planes, and have their surfaces in the others
  open,     ///< more faces coincide in some than in others, but these are no surfaces of bodies that touch
  alike,    ///< equally many coincide in each: only what is elsewhere tells whether bodies touch in all of them
};

/// Marks the half-planes in which bodies touch. Those with the fewest faces are surfaces: they bound, in turn, what is inside and
/// what is outside. Bodies touch in the others if all of these are on one of the two.
///
/// Cost: O(m log m) comparisons for m half-planes.
Touching mark_contacts(HalfPlanes& half_planes);

/// Whether the surface of a half-plane goes on flat through the edge, in as many faces or more: it does not end there.
bool goes_on(const HalfPlanes& half_planes, const HalfPlane& h);

/// The sets of faces that coincide around a part of an edge, where that tells more than the part itself needs.
struct CoincidentFaces {
  Touching touching;
  std::vector<std::vector<FaceId>> sets;  ///< where it is open: those that end there
};

/// Where bodies touch in all half-planes around a part of an edge: in a corner among four boxes, say.
///
/// Parts around which equally many faces coincide in each half-plane lead from one of these to the other. Bodies touch in all that
/// lead to one another if somewhere they touch in one of them, and nowhere one of them ends in the open. So in a file in which
/// every face is stored twice they touch nowhere.
class TouchingRegions {
 public:
  explicit TouchingRegions(std::span<const std::span<const CoincidentFaces>> logs);
  enum class Verdict : std::uint8_t { apart, in_doubt, touch };
  /// In doubt where parts lead both to where bodies touch and to where one ends. @pre touching == Touching::alike
  Verdict verdict(const CoincidentFaces& part) const;

 private:
  std::uint32_t region(const std::vector<FaceId>& set) const { return region_of_[numbers_.at(set)]; }

  std::map<std::vector<FaceId>, std::uint32_t> numbers_;
  std::vector<std::uint32_t> region_of_;         // by number: its least member
  std::vector<std::uint8_t> touches_, is_open_;  // by least member
};

}  // namespace hsr::internal
