#pragma once

// Readers of models and orders, writers of drawings, pictures and results.

// IWYU pragma: begin_exports
#include "hsr/io/read/read.h"
#include "hsr/io/write/json.h"
#include "hsr/io/write/write.h"
// IWYU pragma: end_exports
