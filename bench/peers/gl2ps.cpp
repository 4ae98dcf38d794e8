#include <gl2ps.h>

#include <chrono>
#include <cstdio>
#include <string_view>

#include "bench/peers/painters.h"
#include "bench/peers/seen_points.h"
#include "geometry/error.h"

namespace hsr::bench {

namespace {

/// Counts the lines that paint: it writes "... T" for a triangle, "... ST" for a shaded one, and so on for each piece.
struct Counter {
  std::uint64_t pieces = 0;
  char before = 0;
};

ssize_t count(void* cookie, const char* text, std::size_t size) {
  auto& counter = *static_cast<Counter*>(cookie);
  for (std::size_t k = 0; k < size; ++k) {
    if (text[k] == '\n' && counter.before == 'T') ++counter.pieces;
    counter.before = text[k];
  }
  return static_cast<ssize_t>(size);
}

}  // namespace

PeerOrder gl2ps(const Mesh& mesh, const View& view) {
  constexpr double size = 1000;
  const auto points = seen_points(mesh, view, size);
  Counter counter;
  cookie_io_functions_t functions = {};
  functions.write = count;
  std::FILE* const out = fopencookie(&counter, "w", functions);
  require(out != nullptr, "gl2ps: no stream");
  GLint viewport[] = {0, 0, static_cast<GLint>(size), static_cast<GLint>(size)};
  require(gl2psBeginPage("", "", viewport, GL2PS_PS, GL2PS_BSP_SORT,
                         GL2PS_NO_OPENGL_CONTEXT | GL2PS_NO_BLENDING | GL2PS_BEST_ROOT | GL2PS_SILENT | GL2PS_NO_PS3_SHADING,
                         GL_RGBA, 0, nullptr, 0, 0, 0, 0, out, "") == GL2PS_SUCCESS,
          "gl2ps: no page");
  for (const auto& corners : mesh.triangles) {
    GL2PSvertex vertices[3] = {};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& p = points[corners[k].value];
      // Its depth grows away from the viewer.
      vertices[k].xyz[0] = static_cast<GLfloat>(p[0]);
      vertices[k].xyz[1] = static_cast<GLfloat>(p[1]);
      vertices[k].xyz[2] = static_cast<GLfloat>(size - p[2]);
      vertices[k].rgba[3] = 1;
    }
    gl2psAddPolyPrimitive(GL2PS_TRIANGLE, 3, vertices, 0, 0, 0, 0, 0, 0, 0, 0, 0);
  }
  const auto start = std::chrono::steady_clock::now();
  const GLint status = gl2psEndPage();
  PeerOrder order;
  order.compute = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::fclose(out);
  require(status == GL2PS_SUCCESS && counter.pieces > 0, "gl2ps: it failed");
  order.pieces = counter.pieces;
  return order;
}

}  // namespace hsr::bench
