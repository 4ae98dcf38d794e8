#pragma once

#include <string>
#include <vector>

namespace hsr::internal {

/// A page to read in order, with small runs of the methods between the words.
struct Lesson {
  std::string name;  ///< "lesson-image-space"
  std::string title, about;
  std::string page;  ///< HTML
};

/// Image space, then object space: about an hour. @param made one line on what made them
std::vector<Lesson> all_lessons(const std::string& made);

}  // namespace hsr::internal
