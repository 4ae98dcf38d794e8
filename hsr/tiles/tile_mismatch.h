#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace hsr::internal {

/// Pieces that do not fit together: one ends at a side of its tile where nothing goes on.
struct TileMismatch : std::runtime_error {
  /// @param what "line"
  TileMismatch(std::uint32_t at, const std::string& what)
      : std::runtime_error(
            "tile " + std::to_string(at) + ": found a " + what +
            " that goes on beyond its side, where no other tile has it: a tile is missing, old or of another scene"),
        tile(at),
        thing(what) {}
  std::uint32_t tile;  ///< whose piece it is
  std::string thing;
};

}  // namespace hsr::internal
