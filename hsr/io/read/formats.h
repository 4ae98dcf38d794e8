#pragma once

#include "hsr/io/read/source.h"
#include "hsr/model.h"

namespace hsr::internal::read {

// One reader per format. Each takes the inflated bytes and throws InputError in one line.
Model read_obj(const Source& source);
Model read_off(const Source& source);
Model read_ply(const Source& source);
Model read_stl(const Source& source);
Model read_gltf(const Source& source);

// What the content says.
bool looks_like_off(const Source& source);         ///< the first word is a keyword of the family
bool looks_like_ply(const Source& source);         ///< the first line is "ply"
bool looks_like_binary_stl(const Source& source);  ///< the size is that of the triangles it counts
bool looks_like_ascii_stl(const Source& source);   ///< begins with "solid", and text follows
bool looks_like_gltf(const Source& source);        ///< "glTF", or JSON with an "asset"

}  // namespace hsr::internal::read
