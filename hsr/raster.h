#pragma once

// Pictures of samples: the exact caster and the z-buffer.

// IWYU pragma: begin_exports
#include "hsr/raster/caster.h"
#include "hsr/raster/samples.h"
#include "hsr/raster/z_buffer.h"
// IWYU pragma: end_exports
