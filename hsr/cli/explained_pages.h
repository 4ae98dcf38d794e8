#pragma once

#include <string>
#include <vector>

#include "hsr/cli/directory.h"
#include "study/explain/explained_methods.h"
#include "study/explain/lessons.h"

namespace hsr::cli {

/// Writes METHOD.html and METHOD.json of each method, and index.html.
/// @param prefix of the names: empty, or a directory with its slash @param scene what is explained; null: an example for each method
/// @param size samples each way @throws InputError as the methods do
void write_explained(OutputDirectory& directory, const std::string& prefix, const std::vector<ExplainedMethod>& methods,
                     const ExplainedScene* scene, int size, bool has_lessons);

}  // namespace hsr::cli
