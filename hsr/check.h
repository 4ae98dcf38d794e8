#pragma once

// Results compared with the nearest face at each sample.

// IWYU pragma: begin_exports
#include "hsr/check/sample_checks.h"
// IWYU pragma: end_exports
