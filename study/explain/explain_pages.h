#pragma once

#include <string>
#include <vector>

#include "study/explain/explained_methods.h"
#include "study/explain/lessons.h"

namespace hsr::internal {

/// A page of a method, and its data: self-contained, light and dark, by mouse, finger and keyboard, on paper.
/// @param made one line on what made it @param beside names of the pages that are there, too: others are no links
std::string explain_page(const ExplainedMethod& method, const Trace& trace, const std::string& made,
                         const std::vector<std::string>& beside);

/// The page from which the others are reached.
std::string explain_index(const std::vector<ExplainedMethod>& methods, const std::vector<Lesson>& lessons,
                          const std::string& made);

/// A page of text with traces where it has "{{trace:name}}". @param text a file of study/pages
std::string lesson_page(const std::string& title, std::string_view text,
                        const std::vector<std::pair<std::string, std::string>>& traces, const std::string& made);

}  // namespace hsr::internal
