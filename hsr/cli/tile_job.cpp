#include "hsr/cli/tile_job.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>

#include "geometry/error.h"
#include "hsr/cli/batch_manifest.h"
#include "hsr/tiles/tile_bytes.h"

namespace hsr::cli {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view tile_magic = "hsr-tile/1\n", part_magic = "hsr-part/2\n";
constexpr std::size_t hash_size = 32;

Json json_of(const Point3& p) { return {p.x, p.y, p.z}; }
Point3 point_of(const Json& json) { return {json.at(0), json.at(1), json.at(2)}; }

Json json_of_view(const ChosenView& chosen) {
  const View& v = chosen.view;
  Json json = {{"viewpoint", json_of(v.viewpoint.at)},
               {"is_direction", v.viewpoint.is_direction},
               {"target", json_of(v.target)},
               {"up", json_of(v.up)},
               {"near", v.near},
               {"origin", json_of(v.frame.origin)},
               {"right", json_of(v.frame.right)},
               {"frame_up", json_of(v.frame.up)},
               {"title", chosen.title}};
  if (chosen.field_of_view) json["fov"] = *chosen.field_of_view;
  return json;
}

ChosenView view_of(const Json& json) {
  ChosenView chosen;
  chosen.view.viewpoint = {point_of(json.at("viewpoint")), json.at("is_direction")};
  chosen.view.target = point_of(json.at("target"));
  chosen.view.up = point_of(json.at("up"));
  chosen.view.near = json.at("near");
  chosen.view.frame = {point_of(json.at("origin")), point_of(json.at("right")), point_of(json.at("frame_up"))};
  chosen.title = json.at("title");
  if (json.contains("fov")) chosen.field_of_view = json.at("fov").get<double>();
  return chosen;
}

Json json_of_model(const Model& m) {
  Json json = {
      {"name", m.name}, {"format", m.format}, {"palette", m.palette}, {"objects", m.objects}, {"materials", m.materials}};
  if (m.unit) json["unit"] = *m.unit;
  if (m.up_axis) json["up_axis"] = std::string(1, *m.up_axis);
  return json;
}

Model model_of(const Json& json) {
  Model m;
  m.name = json.at("name");
  m.format = json.at("format");
  m.palette = json.at("palette").get<std::vector<Colour>>();
  m.objects = json.at("objects").get<std::vector<std::string>>();
  m.materials = json.at("materials").get<std::vector<std::string>>();
  if (json.contains("unit")) m.unit = json.at("unit").get<double>();
  if (json.contains("up_axis")) m.up_axis = json.at("up_axis").get<std::string>().at(0);
  return m;
}

Json json_of_job(const TileJob& job) {
  Json tiles = Json::array(), sides = Json::array(), splits = Json::array();
  for (const TileJob::Tile& t : job.tiles) tiles.push_back({{"faces", t.faces}, {"bytes", t.bytes}, {"hash", t.hash}});
  for (const ImageTiles::Side& s : job.image.sides) sides.push_back({json_of(s.c), json_of(s.d)});
  for (const ImageTiles::Split& s : job.image.splits) splits.push_back({s.negative, s.positive});
  return {{"format", "hsr-job/1"},
          {"made_by", std::string("hsr ") + HSR_VERSION},
          {"model", json_of_model(job.names)},
          {"view", json_of_view(job.chosen)},
          {"unit", job.unit},
          {"lines",
           {{"edges", job.lines.edges},
            {"crease", job.lines.crease},
            {"method", job.lines.method},
            {"stages", job.lines.stages},
            {"coplanar", job.coplanar},
            {"hidden", job.hidden},
            {"complete", job.is_complete},
            {"fill", job.has_fills}}},
          {"sides", std::move(sides)},
          {"splits", std::move(splits)},
          {"tiles", std::move(tiles)}};
}

std::string text_of(const Json& json) { return json.dump(1, ' ', false, Json::error_handler_t::replace); }

std::string contents_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file || fs::is_directory(path))
    throw InputError(path + ": cannot be opened, expected a file that hsr split or hsr tile has written");
  std::string bytes(static_cast<std::size_t>(file.tellg()), '\0');
  file.seekg(0);
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!file) throw InputError(path + ": cannot be read to its end");
  return bytes;
}

void sync_directory(const std::string& path) {
  const int directory = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (directory < 0) return;
  fsync(directory);
  close(directory);
}

void write_durably(const std::string& path, std::initializer_list<std::string_view> bytes, UnfinishedFiles& unfinished) {
  OutputFile file(path, &unfinished);
  for (const std::string_view some : bytes) file.write(some);
  file.sync();
  file.commit();
  sync_directory(fs::path(path).parent_path().string());
}

/// Of a part that is whole: what it begins with, and its content.
struct PartBytes {
  std::string bytes;
  std::string_view content() const {
    return std::string_view(bytes).substr(part_magic.size() + hash_size, bytes.size() - part_magic.size() - 2 * hash_size);
  }
};

}  // namespace

TileRequest TileJob::request() const {
  TileRequest request;
  request.lines = lines.options();
  request.scene = lines.scene_options();
  request.scene.coplanar = coplanar == "last" ? Coplanar::last : Coplanar::first;
  request.only_visible = !is_complete;
  request.fragments = has_fills;
  return request;
}

std::string TileJob::tile_path(std::uint32_t tile) const { return directory + "/tile-" + std::to_string(tile + 1); }
std::string TileJob::part_path(std::uint32_t tile) const { return directory + "/part-" + std::to_string(tile + 1); }

void write_job(TileJob& job, UnfinishedFiles& unfinished) {
  Json json = json_of_job(job);
  job.hash = hash_of_text(text_of(json));
  json["hash"] = job.hash;
  write_durably(job.directory + "/job.json", {text_of(json), "\n"}, unfinished);
}

TileJob read_job(const std::string& directory) {
  const std::string path = directory + "/job.json";
  if (!fs::is_directory(directory)) throw InputError(directory + ": found no directory, expected one that hsr split has made");
  const auto refuse = [&](const std::string& found) {
    throw InputError(path + ": " + found + ", expected it as hsr split has written it");
  };
  try {
    Json json = Json::parse(contents_of(path));
    TileJob job;
    job.directory = directory;
    if (json.at("format") != "hsr-job/1") refuse("found the format " + json.at("format").dump());
    job.hash = json.at("hash");
    json.erase("hash");
    if (hash_of_text(text_of(json)) != job.hash) refuse("found a hash that is not that of what it says");
    job.names = model_of(json.at("model"));
    job.chosen = view_of(json.at("view"));
    job.unit = json.at("unit");
    const Json& lines = json.at("lines");
    job.lines.edges = lines.at("edges");
    job.lines.crease = lines.at("crease");
    job.lines.method = lines.at("method");
    job.lines.stages = lines.at("stages");
    job.coplanar = lines.at("coplanar");
    job.hidden = lines.at("hidden");
    job.is_complete = lines.at("complete");
    job.has_fills = lines.value("fill", false);
    for (const Json& s : json.at("sides")) job.image.sides.push_back({point_of(s.at(0)), point_of(s.at(1))});
    for (const Json& s : json.at("splits")) job.image.splits.push_back({s.at(0), s.at(1)});
    for (const Json& t : json.at("tiles")) job.tiles.push_back({t.at("faces"), t.at("bytes"), t.at("hash")});
    if (job.tiles.size() != job.image.count() || job.image.sides.size() != job.image.splits.size())
      refuse("found " + std::to_string(job.tiles.size()) + " tiles");
    return job;
  } catch (const nlohmann::json::exception&) {
    refuse("found no JSON of a job");
  }
  throw InvariantError("read_job");
}

void write_tile(TileJob& job, std::uint32_t tile, const ModelPart& part, UnfinishedFiles& unfinished) {
  std::string bytes = bytes_of(part);
  bytes.insert(0, tile_magic);
  write_durably(job.tile_path(tile), {bytes}, unfinished);
  job.tiles.resize(std::max<std::size_t>(job.tiles.size(), tile + 1));
  job.tiles[tile] = {part.faces.size(), bytes.size(), hash_of_text(bytes)};
}

ModelPart read_tile(const TileJob& job, std::uint32_t tile) {
  const std::string path = job.tile_path(tile), bytes = contents_of(path);
  if (hash_of_text(bytes) != job.tiles[tile].hash)
    throw InputError(path +
                     ": found other bytes than those that the job was split into, expected it as hsr split has written it");
  ModelPart part = model_part_of(std::string_view(bytes).substr(tile_magic.size()));
  Model names = job.names;
  names.points = std::move(part.model.points);
  names.polygons = std::move(part.model.polygons);
  names.face_colour = std::move(part.model.face_colour);
  names.face_object = std::move(part.model.face_object);
  names.face_material = std::move(part.model.face_material);
  names.segment_object = std::move(part.model.segment_object);
  part.model = std::move(names);
  return part;
}

void write_part(const TileJob& job, std::uint32_t tile, const TilePart& part, UnfinishedFiles& unfinished) {
  std::string bytes = bytes_of(part);
  bytes.insert(0, std::string(part_magic) + job.hash);
  write_durably(job.part_path(tile), {bytes, hash_of_text(bytes)}, unfinished);
}

std::optional<std::string> wrong_with_part(const TileJob& job, std::uint32_t tile) {
  const std::string path = job.part_path(tile);
  std::error_code error;
  if (!fs::exists(path, error)) return path + ": missing, tile " + std::to_string(tile + 1) + " is not done";
  try {
    const std::string bytes = contents_of(path);
    if (bytes.size() < part_magic.size() + 2 * hash_size || !bytes.starts_with(part_magic) ||
        hash_of_text(bytes.substr(0, bytes.size() - hash_size)) != bytes.substr(bytes.size() - hash_size))
      return path + ": not whole, expected the part of tile " + std::to_string(tile + 1) + " as hsr tile has written it";
    if (bytes.substr(part_magic.size(), hash_size) != job.hash)
      return path + ": of another job, expected the part of tile " + std::to_string(tile + 1) + " of this one";
    std::uint32_t number = 0;
    std::memcpy(&number, bytes.data() + part_magic.size() + hash_size, sizeof number);
    if (number != tile) return fmt::format("{}: of tile {}, expected the part of tile {}", path, number + 1, tile + 1);
  } catch (const InputError& e) {
    return e.what();
  }
  return std::nullopt;
}

TilePart read_part(const TileJob& job, std::uint32_t tile) {
  const PartBytes part{contents_of(job.part_path(tile))};
  try {
    return tile_part_of(part.content());
  } catch (const InputError& e) {
    throw InputError(job.part_path(tile) + ": " + e.what());
  }
}

}  // namespace hsr::cli
