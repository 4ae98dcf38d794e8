#pragma once

// Models in 3MF, through lib3mf.

// IWYU pragma: begin_exports
#include "hsr/three_mf/three_mf.h"
// IWYU pragma: end_exports
