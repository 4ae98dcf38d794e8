#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "geometry/index.h"
#include "geometry/view_plane.h"
#include "hsr/image.h"
#include "hsr/raster/sample_signs.h"

namespace hsr::internal {

/// A side of a polygon as the rasterizer sees it: it lies in a plane through the viewpoint, and crosses the rows
/// first_row ... end_row - 1. Without rows it does not count: sides along a row have none.
///
/// The rows are those of SampleSigns::rows_above for its ends, in ascending order, so exactly as many sides begin below a row
/// as end there, and every row crosses an even number of them.
struct RasterSide {
  ViewPlane plane;  ///< in the coordinates of the sight
  int first_row = 0, end_row = 0;
};

/// Samples begin ... end - 1 of a row.
struct SampleSpan {
  int row = 0, begin = 0, end = 0;
  friend bool operator==(const SampleSpan&, const SampleSpan&) = default;
};

/// Finds the samples of polygons, each given by all its sides: outer ring and holes in any order and orientation, even-odd.
///
///   (1) a sample is inside iff an odd number of sides pass on its left, exactly, with the rule for samples on edges
///   (2) polygons that cover an area once, as seen, cover each of its samples once: common sides neither overlap nor leave
///       holes
///
/// Corners may be constructed points: only the planes of the sides and the rows of their ends matter.
/// One object per thread. Exact: yes. Cost: O(sides log sides + crossings), a few ns each in doubles, plus samples painted.
/// Source: scan conversion as in Wylie, Romney, Evans & Erdahl 1967; the rule for edges, samples.h.
class Rasterizer {
 public:
  explicit Rasterizer(const SampleSigns& signs) : signs_(signs), exact_(signs.projected().predicates()) {}

  /// The spans of a polygon, rows ascending, in a row from the left, none touching the next; valid until the next call.
  std::span<const SampleSpan> spans(std::span<const RasterSide> sides);
  /// The spans of a triangle of the mesh, of what is beyond the near plane. Seen edge-on: none.
  std::span<const SampleSpan> spans(TriangleId t);

  /// The sides of a triangle, appended. @pre all corners are in front (SampleSigns::is_in_front)
  void append_sides(TriangleId t, std::vector<RasterSide>& sides);

  template <class T>
  static void paint(Image<T>& image, std::span<const SampleSpan> spans, const T& value) {
    for (const SampleSpan& s : spans) std::fill(image.row(s.row) + s.begin, image.row(s.row) + s.end, value);
  }

  Predicates& exact() { return exact_; }
  const DecisionCounts& counts() const { return exact_.counts(); }

 private:
  struct Active {
    SampleFunction function;
    const RasterSide* side;
    int end_row;
  };

  static constexpr int unknown = -1, not_in_front = -2;
  /// Of a vertex: where it is seen, in rows and columns of samples; rows above it, columns before it, for either a negative
  /// number, if there is none or it is not known.
  struct Place {
    ErrorBounded y, x;
    int row = unknown, column = unknown;
  };

  struct SideOfTriangle;

  const Place& place(VertexId v);
  template <class MakePlane>
  int samples_before(const SampleFunction& f, int j, const MakePlane& plane);
  void cut_rows(TriangleId t);

  const SampleSigns& signs_;
  Predicates exact_;
  std::vector<SampleSpan> spans_;
  std::vector<const RasterSide*> order_;
  std::vector<Active> active_;
  std::vector<int> crossings_;
  std::vector<Place> places_;  // by vertex; made when first asked for
};

}  // namespace hsr::internal
