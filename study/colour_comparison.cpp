#include "study/colour_comparison.h"

#include <algorithm>
#include <cmath>

#include "hsr/painter/sort/z_sort.h"
#include "hsr/raster/a_buffer.h"
#include "hsr/raster/alpha_buffer.h"
#include "hsr/raster/caster.h"
#include "hsr/raster/supersampling.h"
#include "hsr/raster/z_buffer.h"

namespace hsr::internal {

namespace {

constexpr double half = 0.5;

/// Colours that neighbours do not share: faces in steps around three circles.
std::vector<Colour> colours_of_faces(std::size_t n) {
  std::vector<Colour> colours(n);
  for (std::size_t f = 0; f < n; ++f)
    colours[f] = {static_cast<std::uint8_t>(40 + f * 89 % 200), static_cast<std::uint8_t>(40 + f * 55 % 200),
                  static_cast<std::uint8_t>(40 + f * 144 % 200), 255};
  return colours;
}

void compare(ComparedColours& row, const Image<Colour>& found, const Image<Colour>& expected) {
  double sum = 0;
  std::size_t changed = 0;
  for (std::size_t p = 0; p < found.pixels.size(); ++p) {
    double most = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double difference = std::fabs(static_cast<double>(found.pixels[p][k]) - expected.pixels[p][k]);
      sum += difference;
      most = std::max(most, difference);
    }
    row.most_difference = std::max(row.most_difference, most);
    changed += most > 1 ? 1U : 0U;
  }
  const auto pixels = static_cast<double>(std::max<std::size_t>(found.pixels.size(), 1));
  row.mean_difference = sum / (3 * pixels);
  row.changed_share = static_cast<double>(changed) / pixels;
}

std::string square(int n) { return std::to_string(n) + " x " + std::to_string(n); }

const Colour white = {255, 255, 255, 255};

/// What triangles have as colours. @param triangle_of of a pixel
template <class Pixel, class TriangleOf>
Image<Colour> coloured(const Mesh& mesh, const Image<Pixel>& picture, const std::vector<Colour>& colours,
                       const TriangleOf& triangle_of) {
  Image<Colour> out(picture.width, picture.height);
  std::transform(picture.pixels.begin(), picture.pixels.end(), out.pixels.begin(), [&](const Pixel& p) {
    const TriangleId t = triangle_of(p);
    return t.is_valid() ? colours[mesh.face_of[t].value] : white;
  });
  return out;
}

}  // namespace

std::vector<ComparedColours> compare_supersampling(const Mesh& mesh, const View& view, const PaintersOrder& order,
                                                   double order_seconds, const std::function<SampleGrid(int size)>& grid,
                                                   int size, const Timer& timed, Coplanar coplanar) {
  constexpr int many = 16;
  const std::vector<Colour> colours = colours_of_faces(mesh.faces.size());
  const auto itself = [](TriangleId t) { return t; };
  const Image<Colour> expected = box_filtered(
      coloured(mesh, cast(SceneView(mesh, view, {.coplanar = coplanar}), grid(many * size)).triangles, colours, itself), many);
  std::vector<ComparedColours> rows;
  const auto add = [&](const std::string& method, double seconds_before, const auto& draw) {
    for (const int n : {1, 2, 4, 8}) {
      ComparedColours row{method, square(n)};
      Image<Colour> found;
      row.seconds = seconds_before + timed([&] {
                      found = supersampled(
                          size, size, n, [&](int width, int) { return grid(width); }, draw);
                    });
      compare(row, found, expected);
      rows.push_back(row);
    }
  };
  add("z-buffer, float", 0, [&](const SampleGrid& g) {
    return coloured(mesh, z_buffer<float>(mesh, view, g, coplanar), colours,
                    [](const DepthPixel<float>& p) { return p.triangle; });
  });
  PaintersOrder by_centroid;
  const double sorting =
      timed([&] { by_centroid = z_sort(SceneView(mesh, view, {.coplanar = coplanar}), DepthKey::centroid); });
  add("painter, by the centroid", sorting, [&](const SampleGrid& g) { return paint(mesh, view, by_centroid, g, colours, 1); });
  add("painter's order, by depth sort", order_seconds,
      [&](const SampleGrid& g) { return paint(mesh, view, order, g, colours, 1); });
  return rows;
}

std::vector<ComparedColours> compare_transparency(const Mesh& mesh, const View& view, const PaintersOrder& order,
                                                  double order_seconds, const std::function<SampleGrid(int size)>& grid,
                                                  int size, const Timer& timed, Coplanar coplanar) {
  const std::vector<Colour> colours = colours_of_faces(mesh.faces.size());
  const auto grid_of = [&](int width, int) { return grid(width); };
  const auto by_order = [&](int n) {
    return supersampled(size, size, n, grid_of,
                        [&](const SampleGrid& g) { return paint(mesh, view, order, g, colours, half); });
  };
  const Image<Colour> expected = by_order(8);
  std::vector<ComparedColours> rows;
  const auto add = [&](const std::string& method, const std::string& samples, double seconds_before, const auto& draw) {
    ComparedColours row{method, samples};
    Image<Colour> found;
    row.seconds = seconds_before + timed([&] { found = draw(row); });
    compare(row, found, expected);
    rows.push_back(row);
  };
  for (const int n : {1, 4})
    add("painter's order, by depth sort", square(n), order_seconds, [&](ComparedColours&) { return by_order(n); });
  for (const int n : {1, 2, 4})
    add("alpha-buffer", square(n), 0, [&](ComparedColours& row) {
      return supersampled(size, size, n, grid_of, [&](const SampleGrid& g) {
        AlphaBuffer found = alpha_buffer(mesh, view, g, colours, half, coplanar);
        row.bytes = found.bytes;
        return std::move(found.picture);
      });
    });
  add("A-buffer", "masks of 8 x 4", 0, [&](ComparedColours& row) {
    ABuffer found = a_buffer(mesh, view, grid(size), colours, half, coplanar);
    row.bytes = found.bytes;
    return std::move(found.picture);
  });
  return rows;
}

}  // namespace hsr::internal
