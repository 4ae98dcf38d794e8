#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace hsr::internal {

using Json = nlohmann::json;

/// The state after all steps of a run, as the page makes it.
struct Ended {
  std::vector<int> painted;                                          // faces
  std::map<std::pair<int, int>, std::pair<std::string, int>> cells;  // by column and row: text, face
  std::map<int, std::vector<std::pair<double, double>>> visible;     // by edge
  std::set<int> nodes;
  std::vector<Json> drawn;                             // lines of the picture
  std::map<std::pair<int, int>, std::string> colours;  // of cells that have their own
  std::vector<int> kept;                               // faces of the list of this name
};

Ended ended(const Json& run);

/// Of a page, in their order.
std::vector<Json> traces_of(const std::string& page);

/// What holds for every trace.
void check_form(const Json& trace);

/// The end of each run, and its result.
void check_end(const Json& trace);

}  // namespace hsr::internal
