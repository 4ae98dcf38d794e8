#pragma once

// Readers of models and orders, writers of drawings, pictures and results.

// IWYU pragma: begin_exports
#include "hsr/io/read/order_json.h"
#include "hsr/io/read/read.h"
#include "hsr/io/write/dxf.h"
#include "hsr/io/write/eps.h"
#include "hsr/io/write/hpgl.h"
#include "hsr/io/write/image_png.h"
#include "hsr/io/write/json.h"
#include "hsr/io/write/order_json.h"
#include "hsr/io/write/pdf.h"
#include "hsr/io/write/png.h"
#include "hsr/io/write/svg.h"
#include "hsr/io/write/tikz.h"
// IWYU pragma: end_exports
