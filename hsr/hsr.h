#pragma once

// All of the exact core: meshes, views, visible lines and fragments, painter's orders, hidden points, drawings. Readers and
// writers are in hsr/io.h, pictures of samples in hsr/raster.h, checks in hsr/check.h, matrices in hsr/eigen.h.

// IWYU pragma: begin_exports
#include "geometry/error.h"
#include "geometry/mesh.h"
#include "geometry/threads.h"
#include "hsr/coordinates/coordinates.h"
#include "hsr/drawing/drawing.h"
#include "hsr/drawing/painting.h"
#include "hsr/lines/hidden_points.h"
#include "hsr/lines/overhead.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/model.h"
#include "hsr/painter/bsp/bsp.h"
#include "hsr/painter/sort/depth_sort.h"
#include "hsr/painter/verify/verify.h"
#include "hsr/scene/scene.h"
#include "hsr/sheet/sheet.h"
#include "hsr/surfaces/regions.h"
#include "hsr/surfaces/section.h"
#include "hsr/surfaces/visible_fragments.h"
#include "hsr/symbols/constructions.h"
#include "hsr/view/view.h"
// IWYU pragma: end_exports
