// Line Art, a modifier of Blender: feature lines of meshes, in floats. Run in a Blender of its own, whose start is not counted.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "bench/peers/image.h"
#include "bench/peers/peer.h"
#include "geometry/error.h"
#include "hsr/lines/visible_lines.h"

namespace hsr::bench {

namespace {

namespace fs = std::filesystem;

/// How far a stroke may be from the place that it shows, of the picture's size: floats are more exact, other lines are farther.
constexpr double near = 1e-5;

class Directory {
 public:
  Directory() {
    std::string name = (fs::temp_directory_path() / "hsr-line-art-XXXXXX").string();
    require(::mkdtemp(name.data()) != nullptr, "line art: no temporary directory");
    path_ = name;
  }
  Directory(const Directory&) = delete;
  Directory& operator=(const Directory&) = delete;
  ~Directory() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  std::string operator/(const char* name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

template <class T>
void put(std::ofstream& file, const T& x) {
  file.write(reinterpret_cast<const char*>(&x), sizeof x);
}

template <class T>
T take(std::ifstream& file) {
  T x{};
  file.read(reinterpret_cast<char*>(&x), sizeof x);
  return x;
}

/// Half of a picture around the target that shows all.
double half_of_picture(const Mesh& mesh, const View& view) {
  const Image image(view);
  double half = 0;
  for (const Edge& e : mesh.edges)
    for (const VertexId v : {e.a, e.b}) {
      const ImagePoint p = image(mesh.points[v]);
      half = std::max({half, std::fabs(p.x), std::fabs(p.y)});
    }
  return 1.05 * half;
}

void write_scene(const std::string& path, const Task& task, double crease) {
  std::ofstream file(path, std::ios::binary);
  const Mesh& mesh = task.mesh;
  put(file, static_cast<std::int64_t>(mesh.points.size()));
  put(file, static_cast<std::int64_t>(mesh.triangles.size()));
  const auto point = [&](const Point3& p) {
    for (const double x : {p.x, p.y, p.z}) put(file, x);
  };
  const View& v = task.view;
  point(v.viewpoint.at);
  put(file, v.viewpoint.w());
  for (const Point3& p : {v.target, v.frame.right, v.frame.up}) point(p);
  put(file, half_of_picture(mesh, v));
  put(file, crease);
  for (const Point3& p : mesh.points) point(p);
  for (const auto& corners : mesh.triangles)
    for (const VertexId c : corners) put(file, static_cast<std::int32_t>(c.value));
}

using Segment = std::pair<Point3, Point3>;

/// The strokes that Blender wrote, and its times.
std::vector<Segment> read_strokes(const std::string& path, Elapsed& times) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError("Blender wrote no lines; is it installed?");
  times.clock = take<double>(file);
  times.processor = take<double>(file);
  std::vector<std::int64_t> counts(static_cast<std::size_t>(take<std::int64_t>(file)));
  for (std::int64_t& count : counts) count = take<std::int64_t>(file);
  std::vector<Segment> segments;
  for (const std::int64_t count : counts) {
    Point3 before;
    for (std::int64_t k = 0; k < count; ++k) {
      const double x = take<double>(file), y = take<double>(file), z = take<double>(file);
      if (k > 0) segments.push_back({before, {x, y, z}});
      before = {x, y, z};
    }
  }
  require(file.good(), "line art: the strokes are cut short");
  return segments;
}

double distance(const Point3& p, const Segment& s) {
  const Point3 d = {s.second.x - s.first.x, s.second.y - s.first.y, s.second.z - s.first.z};
  const Point3 v = {p.x - s.first.x, p.y - s.first.y, p.z - s.first.z};
  const double square = d.x * d.x + d.y * d.y + d.z * d.z;
  const double t = square > 0 ? std::clamp((v.x * d.x + v.y * d.y + v.z * d.z) / square, 0.0, 1.0) : 0;
  return std::hypot(v.x - t * d.x, v.y - t * d.y, v.z - t * d.z);
}

/// Visible where a stroke runs through the place. Asked are places on the edges that hsr draws, too: others are no lines of it.
std::vector<Answer> answers_of(const std::vector<Segment>& segments, const Task& task) {
  const double size = 2 * half_of_picture(task.mesh, task.view), cell = size / 64, reach = near * size;
  std::vector<char> is_drawn(task.mesh.edges.size(), 0);
  for (const Line& line : visible_lines(task.mesh, task.view).lines)
    if (!line.is_intersection()) is_drawn[line.edge.value] = 1;
  std::vector<Answer> answers(task.probes.size(), Answer::none);
  std::map<std::array<long long, 3>, std::vector<std::size_t>> cells;
  std::vector<Point3> places;
  const auto cell_of = [&](const Point3& p) {
    return std::array{std::llround(std::floor(p.x / cell)), std::llround(std::floor(p.y / cell)),
                      std::llround(std::floor(p.z / cell))};
  };
  for (std::size_t k = 0; k < task.probes.size(); ++k) {
    const Edge& e = task.mesh.edges[task.probes[k].edge];
    const Point3 &a = task.mesh.points[e.a], &b = task.mesh.points[e.b];
    const double t = task.probes[k].t;
    places.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)});
    if (is_drawn[task.probes[k].edge.value] == 0) continue;
    answers[k] = Answer::hidden;
    cells[cell_of(places[k])].push_back(k);
  }
  for (const Segment& s : segments) {
    const auto [ax, bx] = std::minmax(s.first.x, s.second.x);
    const auto [ay, by] = std::minmax(s.first.y, s.second.y);
    const auto [az, bz] = std::minmax(s.first.z, s.second.z);
    const auto low = cell_of({ax - reach, ay - reach, az - reach}), high = cell_of({bx + reach, by + reach, bz + reach});
    for (auto x = low[0]; x <= high[0]; ++x)
      for (auto y = low[1]; y <= high[1]; ++y)
        for (auto z = low[2]; z <= high[2]; ++z)
          if (const auto found = cells.find({x, y, z}); found != cells.end())
            for (const std::size_t k : found->second)
              if (distance(places[k], s) <= reach) answers[k] = Answer::visible;
  }
  return answers;
}

}  // namespace

bool has_line_art() { return std::system("command -v blender > /dev/null 2>&1") == 0; }

Result line_art(const Task& task) {
  const Directory directory;
  const std::string in = directory / "scene", out = directory / "strokes";
  write_scene(in, task, LineOptions().crease);
  // It ends with the process that started it. Debian's Blender takes modules from where the first python3 on PATH has its own: another
  // one may stand before Debian's.
  const std::string command = fmt::format(
      "PATH=/usr/bin:$PATH; exec setpriv --pdeathsig KILL blender --background --factory-startup --threads 1 "
      "--python-exit-code 1 "
      "--python '{}' -- '{}' '{}' > /dev/null 2>&1",
      HSR_LINE_ART_SCRIPT, in, out);
  const int status = std::system(command.c_str());
  if (status != 0) throw InputError(fmt::format("Blender ended with status {}", status));
  Result result;
  const std::vector<Segment> segments = read_strokes(out, result.compute);
  result.visible = segments.size();
  result.answers = answers_of(segments, task);
  return result;
}

}  // namespace hsr::bench
