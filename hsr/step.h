#pragma once

// Models of surfaces in STEP and IGES, through Open CASCADE.

// IWYU pragma: begin_exports
#include "hsr/step/step.h"
// IWYU pragma: end_exports
