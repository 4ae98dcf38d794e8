#pragma once

#include <cstdint>
#include <span>

#include "hsr/raster/scanline.h"

namespace hsr::internal {

/// An entry of the edge table, from its upper end.
struct ScannedEdge {
  double x, y, columns_a_row;
  int first_row, end_row;
  std::uint32_t face;
  bool is_left;
};

/// Where an active edge crosses a row: from the first sample right of it on its face is entered, or left.
struct ScannedCrossing {
  int column;
  std::uint32_t face;
  bool is_left;
};

/// Two faces compared, at both ends of the part of the row that both have. Larger is nearer.
struct ScannedComparison {
  std::uint32_t face, shown;
  int first_column, last_column;
  double face_at_first, shown_at_first, face_at_last, shown_at_last;
  bool is_nearer;  ///< the face is
};

/// Is told what the scanline algorithm does, in the order in which it does it. Faces are numbers of the face table.
class ScanlineObserver {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;
  ScanlineObserver() = default;
  ScanlineObserver(const ScanlineObserver&) = delete;
  ScanlineObserver& operator=(const ScanlineObserver&) = delete;
  virtual ~ScanlineObserver() = default;

  virtual void added_face(std::uint32_t face, TriangleId triangle) = 0;
  /// The edge table, by first row.
  virtual void began(std::span<const ScannedEdge> edges) = 0;
  /// A row with its active edges, and where they cross it, from the left.
  virtual void row(int row, std::span<const ScannedEdge> active, std::span<const ScannedCrossing> crossings) = 0;
  /// The flag of a face goes up or down. @param inside the faces whose flag is up
  virtual void passed(const ScannedCrossing& crossing, std::span<const std::uint32_t> inside) = 0;
  virtual void compared(const ScannedComparison& comparison) = 0;
  /// The samples begin ... end - 1 of the row show a face, or none.
  virtual void shown(int row, int begin, int end, std::uint32_t face) = 0;
};

/// scanline(), watched: it does the same and gives the same.
Scanline scanline(const Mesh& mesh, const View& view, const SampleGrid& samples, TieRule ties, ScanlineObserver& observer);

}  // namespace hsr::internal
