#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace hsr::internal {

/// On which side of each of some planes up to 64 parts lie, a bit for each part: what has been asked once need not be asked
/// again. A part on both sides is cut by the plane; one on neither lies in it.
template <std::size_t planes>
class SideBits {
 public:
  static constexpr std::size_t places = 64;
  struct Row {  ///< of a plane: bit k, of the part in place k
    std::uint64_t known = 0, behind = 0, before = 0;
  };

  const Row& operator[](std::size_t plane) const { return rows_[plane]; }

  /// With all of `parts` known. @param sides asked for the place of a part that is not: .behind and .before
  template <class Sides>
  const Row& find(std::size_t plane, std::uint64_t parts, const Sides& sides) {
    Row& row = rows_[plane];
    for (std::uint64_t open = parts & ~row.known; open != 0; open &= open - 1) {
      const int k = std::countr_zero(open);
      const auto found = sides(static_cast<std::size_t>(k));
      row.behind |= std::uint64_t{found.behind} << k;
      row.before |= std::uint64_t{found.before} << k;
    }
    row.known |= parts;
    return row;
  }

  /// The part in one place is cut into two, the second in another place. What is true of the whole is true of both; a plane
  /// that cuts the whole has to be asked again.
  void cut(std::size_t whole, std::size_t second) {
    const std::uint64_t bit = std::uint64_t{1} << whole, other = std::uint64_t{1} << second;
    for (Row& row : rows_) {
      const bool was_cut = (row.behind & row.before & bit) != 0;
      for (std::uint64_t* bits : {&row.known, &row.behind, &row.before}) {
        if (was_cut) *bits &= ~bit;
        *bits = (*bits & bit) != 0 ? *bits | other : *bits & ~other;
      }
    }
  }

 private:
  std::array<Row, planes> rows_ = {};
};

}  // namespace hsr::internal
