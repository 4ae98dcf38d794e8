#pragma once

// Results compared with the nearest face at each sample.

// IWYU pragma: begin_exports
#include "hsr/check/fragment_check.h"
#include "hsr/check/order_check.h"
#include "hsr/check/z_buffer_check.h"
// IWYU pragma: end_exports
