#pragma once

#include <string>
#include <vector>

#include "tests/oracle/seen_edges.h"
#include "tests/scenes/test_scene.h"

namespace hsr {

/// Every class, smooth too.
inline LineOptions all_edges() {
  LineOptions options;
  options.classes.fill(true);
  return options;
}

/// What roberts and the oracle say of one scene. Tests ask for edges by the points' numbers.
class CheckedLines {
 public:
  explicit CheckedLines(const scenes::TestScene& scene, const LineOptions& options = all_edges());

  /// "outline: 0 visible 1", "boundary: nothing", or "absent"; where roberts and the oracle differ, both.
  std::string operator()(std::uint32_t a, std::uint32_t b) const;
  /// The same without the class.
  std::string intervals(std::uint32_t a, std::uint32_t b) const;
  const std::vector<oracle::SeenEdge>& edges() const { return found_; }
  /// How roberts and appel differ from the oracle; empty: they agree.
  const std::string& differences() const { return differences_; }

 private:
  Mesh mesh_;
  std::vector<oracle::SeenEdge> found_;
  std::vector<oracle::SeenEdge> expected_;
  std::string differences_;
};

/// What is wrong with roberts and appel, with and without hidden tiles, on this scene: their differences to the oracle, or the
/// exception. Empty: nothing.
std::string wrong_with(const scenes::TestScene& scene, const LineOptions& options = all_edges());

}  // namespace hsr
