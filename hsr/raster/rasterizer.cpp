#include "hsr/raster/rasterizer.h"

#include <algorithm>
#include <array>
#include <optional>

#include "geometry/error.h"

namespace hsr::internal {

/// How many samples of row j are on the left of a plane that crosses the row, extended to all sides. Where all of them are on
/// one side, the way in which the value changes along the row tells whether they are before or after the crossing.
template <class MakePlane>
int Rasterizer::samples_before(const SampleFunction& f, int j, const MakePlane& plane) {
  const int width = signs_.grid().width;
  const double row = f.on_row(j);
  const RowCut cut = signs_.cut(f, row, j, 0, width, plane, exact_);
  if (cut.change < width) return cut.change;
  const double most = std::fabs(f.right) * width;
  const Sign rising = most > 2 * f.error ? sign_of(f.right) : signs_.slope_along_row(plane(), j);
  return cut.first == rising ? 0 : width;
}

std::span<const SampleSpan> Rasterizer::spans(std::span<const RasterSide> sides) {
  spans_.clear();
  order_.clear();
  active_.clear();
  for (const RasterSide& s : sides)
    if (s.first_row < s.end_row) order_.push_back(&s);
  if (order_.empty()) return {};
  std::sort(order_.begin(), order_.end(), [](const RasterSide* a, const RasterSide* b) { return a->first_row < b->first_row; });
  std::size_t next = 0;
  for (int j = order_.front()->first_row; next < order_.size() || !active_.empty(); ++j) {
    if (active_.empty()) j = order_[next]->first_row;
    for (; next < order_.size() && order_[next]->first_row == j; ++next) {
      const RasterSide& s = *order_[next];
      active_.push_back({signs_.function(s.plane), &s, s.end_row});
    }
    crossings_.clear();
    for (const Active& a : active_) crossings_.push_back(samples_before(a.function, j, [&] { return a.side->plane; }));
    std::sort(crossings_.begin(), crossings_.end());
    for (std::size_t k = 0; k + 1 < crossings_.size(); k += 2) {
      if (crossings_[k] == crossings_[k + 1]) continue;
      if (!spans_.empty() && spans_.back().row == j && spans_.back().end == crossings_[k])
        spans_.back().end = crossings_[k + 1];
      else
        spans_.push_back({j, crossings_[k], crossings_[k + 1]});
    }
    std::erase_if(active_, [&](const Active& a) { return a.end_row == j + 1; });
  }
  return spans_;
}

const Rasterizer::Place& Rasterizer::place(VertexId v) {
  if (places_.empty()) places_.resize(signs_.projected().mesh().points.size());
  Place& p = places_[v.value];
  if (p.row != unknown) return p;
  if (signs_.is_in_front(v, exact_)) {
    const Point3& at = signs_.projected().point(v);
    p.y = signs_.row_of(at);
    p.x = signs_.column_of(at);
    p.row = signs_.rows_above(v, p.y, exact_);
    p.column = certain_count(p.x, signs_.grid().width);
  } else {
    p.row = not_in_front;
  }
  return p;
}

void Rasterizer::append_sides(TriangleId t, std::vector<RasterSide>& sides) {
  const auto& corners = signs_.projected().mesh().triangles[t];
  for (std::size_t k = 0; k < 3; ++k) {
    const VertexId a = corners[k], b = corners[(k + 1) % 3];
    const auto [first, end] = std::minmax({place(a).row, place(b).row});
    require(first != not_in_front, "Rasterizer: corners in front of the viewpoint expected");
    if (first < end) sides.push_back({ViewPlane::of(signs_.projected().sight_plane(a, b)), first, end});
  }
}

struct Rasterizer::SideOfTriangle {
  const Place* from = nullptr;
  ErrorBounded columns_a_row;
  int first_row = 0, end_row = 0;
  std::optional<SampleFunction> function;  // where the columns are not certain
};

std::span<const SampleSpan> Rasterizer::spans(TriangleId t) {
  spans_.clear();
  const ProjectedMesh& projected = signs_.projected();
  if (projected.facing(t) == Sign::zero) return {};
  const auto& corners = projected.mesh().triangles[t];
  const std::array<const Place*, 3> places = {&place(corners[0]), &place(corners[1]), &place(corners[2])};
  const std::array<int, 3> rows = {places[0]->row, places[1]->row, places[2]->row};
  const auto [top, bottom] = std::minmax({rows[0], rows[1], rows[2]});
  // Most triangles of a large mesh lie between the samples: leave early.
  if (top == bottom && top != not_in_front) return {};
  const int column = places[0]->column;
  if (column >= 0 && column == places[1]->column && column == places[2]->column) return {};
  if (top == not_in_front || projected.reaches_before_near(t)) {
    cut_rows(t);
    return spans_;
  }
  // Every row from top to bottom crosses two of the sides.
  std::array<SideOfTriangle, 3> sides;
  for (std::size_t k = 0; k < 3; ++k) {
    const Place &a = *places[k], &b = *places[k == 2 ? 0 : k + 1];
    sides[k] = {&a, {}, std::min(a.row, b.row), std::max(a.row, b.row), {}};
    if (sides[k].first_row < sides[k].end_row) sides[k].columns_a_row = quotient(b.x - a.x, b.y - a.y);
  }
  for (int j = top; j < bottom; ++j) {
    std::array<int, 2> crossing = {0, 0};
    std::size_t n = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      SideOfTriangle& s = sides[k];
      if (j < s.first_row || j >= s.end_row) continue;
      int& before = crossing[n++];
      before = certain_count(s.from->x + (ErrorBounded{static_cast<double>(j), 0} - s.from->y) * s.columns_a_row,
                             signs_.grid().width);
      if (before >= 0) continue;
      const auto plane = [&] { return projected.sight_plane(corners[k], corners[k == 2 ? 0 : k + 1]); };
      if (!s.function) s.function = SampleFunction(projected.filter(plane()), signs_.grid());
      before = samples_before(*s.function, j, [&] { return ViewPlane::of(plane()); });
    }
    const auto [begin, end] = std::minmax(crossing[0], crossing[1]);
    if (begin < end) spans_.push_back({j, begin, end});
  }
  return spans_;
}

/// Where the rows of corners mean nothing: on every row what its planes leave.
void Rasterizer::cut_rows(TriangleId t) {
  const ProjectedMesh& projected = signs_.projected();
  if (!projected.reaches_beyond_near(t)) return;
  const auto& corners = projected.mesh().triangles[t];
  const Sign facing = projected.facing(t);
  std::array<Plane, 4> planes;
  std::array<SampleFunction, 4> functions;
  const std::size_t count = projected.reaches_before_near(t) ? 4 : 3;
  for (std::size_t k = 0; k < count; ++k) {
    planes[k] = k < 3 ? projected.sight_plane(corners[k], corners[(k + 1) % 3]) : projected.near_line(projected.face_plane(t));
    functions[k] = {projected.filter(planes[k]), signs_.grid()};
  }
  for (int j = 0; j < signs_.grid().height; ++j) {
    int begin = 0, end = signs_.grid().width;
    for (std::size_t k = 0; k < count && begin < end; ++k) {
      const RowCut cut = signs_.cut(
          functions[k], functions[k].on_row(j), j, begin, end, [&] { return ViewPlane::of(planes[k]); }, exact_);
      (cut.first == facing ? end : begin) = cut.change;
    }
    if (begin < end) spans_.push_back({j, begin, end});
  }
}

}  // namespace hsr::internal
