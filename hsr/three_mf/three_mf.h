#pragma once

#include <string>
#include <string_view>

#include "hsr/model.h"

namespace hsr {

/// Whether a file is 3MF: by its content, a zip archive, where there is some, or else by its ending.
bool is_three_mf(const std::string& path, std::string_view bytes = {});

/// The model in a 3MF file: what its build puts together of meshes.
///
///   (1) each instance of a mesh is an object, named by its path of components; a second one of a name is "name [2]"
///   (2) points are those that lib3mf reads, which are floats; those of components that are turned or moved are computed in doubles once,
///       and a note says so
///   (3) Z is up; lengths stay in the file's unit where that is mm, cm, m or inches, and become millimetres otherwise
///   (4) a face has the colour and the name of its base material, or the mean of the colours of its corners, else those of its object
///   (5) objects that support others in a printer are left out, as are beams, slices and textures, with a note
///
/// @throws InputError in one line: the file, what was found and what was expected
Model read_three_mf(const std::string& path);
/// The same of its bytes in memory; `path` is the name for messages.
Model read_three_mf(const std::string& path, std::string_view bytes);

}  // namespace hsr
