#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/number.h"
#include "geometry/ragged.h"
#include "hsr/lines/line_options.h"
#include "hsr/scene/scene.h"

namespace hsr {

/// The cut face of one object: what of the section plane is inside it.
struct SectionCap {
  std::uint32_t object = 0;  ///< FaceLabels::object
  FaceId face;               ///< the lowest of its faces that are cut
  std::uint8_t plane = 0;    ///< of several section planes, which: an index of View::planes
  std::uint32_t first_ring = 0, end_ring = 0;
};

/// A straight part of the border of caps.
struct SectionLine {
  std::array<std::array<Rational, 3>, 2> ends;
  /// Where one side is outside, `section`; where objects of two materials touch or overlap, `material`; of one material, `joint`; of an
  /// outline that does not close, `boundary`.
  EdgeClass edge_class = EdgeClass::section;
  std::array<std::uint32_t, 2>
      objects;  ///< inside which its sides are, left and right, of several the lowest that is not on both; none: outside
  FaceId face;  ///< one that is cut there

  static constexpr std::uint32_t none = 0xffffffffU;
};

/// What a section makes of closed bodies. All points are exact, and in the section plane.
struct Section {
  std::vector<SectionCap> caps;           ///< by object
  Ragged<std::array<Rational, 3>> rings;  ///< of the caps, as the viewer sees them: outlines counter-clockwise, holes clockwise
  std::vector<SectionLine> lines;         ///< each part once, whatever objects it is a border of; straight on as far as it goes
  std::size_t open_outlines = 0;          ///< connected outlines of the cut that do not close, and so bound nothing
};

/// The caps of a view with a section (with_section()); of another view, none.
///
/// The plane is taken as if it were moved towards the viewer by less than anything: what lies in it stays, and is no cap of what is
/// behind it. A place is inside an object where the outlines of its cut wind around it; of outlines without one direction, where a ray
/// from it crosses them an odd number of times.
/// Exact: yes. Cost: O(n) for the faces; for m that are cut O(m log m), and a cross product for each two of them that are close.
Section section(const SceneView& scene);

}  // namespace hsr
