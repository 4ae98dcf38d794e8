#include "hsr/tiles/tile_bytes.h"

#include <algorithm>
#include <vector>

#include "geometry/error.h"
#include "hsr/tiles/byte_stream.h"

namespace hsr::internal {

namespace {

/// Start, end and near take no numbers.
bool has_numbers(Cut::Kind kind) { return kind != Cut::Kind::start && kind != Cut::Kind::end && kind != Cut::Kind::near; }

void add(ByteWriter& out, const NamedCut& cut) {
  out.add(static_cast<std::uint8_t>(cut.kind));
  out.add(cut.axis);
  if (!has_numbers(cut.kind)) return;
  out.add(cut.u);
  out.add(cut.v);
}

NamedCut cut_of(ByteReader& in) {
  const auto kind = in.get<std::uint8_t>();
  if (kind > static_cast<std::uint8_t>(Cut::Kind::fold)) ByteReader::refuse();
  NamedCut cut{static_cast<Cut::Kind>(kind), in.get<std::uint8_t>(), 0, 0};
  if (!has_numbers(cut.kind)) return cut;
  cut.u = in.get<std::uint32_t>();
  cut.v = in.get<std::uint32_t>();
  return cut;
}

enum Flag : std::uint8_t {
  ghost = 1,
  behind = 2,
  starts_hidden = 4,
  only_bound = 8,
  goes_on_before = 16,
  goes_on_after = 32,
  intersection = 64,
};

void add(ByteWriter& out, const LinePiece& p, const std::vector<NamedCut>& cuts) {
  const auto flag = [](bool is, Flag f) { return is ? f : 0; };
  out.add(static_cast<std::uint8_t>(flag(p.is_ghost, ghost) | flag(p.is_behind, behind) | flag(p.starts_hidden, starts_hidden) |
                                    flag(p.is_only_bound, only_bound) | flag(p.goes_on_before, goes_on_before) |
                                    flag(p.goes_on_after, goes_on_after) | flag(p.is_intersection(), intersection)));
  out.add(static_cast<std::uint8_t>(p.edge_class));
  if (p.is_intersection()) {
    for (const NamedTriangle& t : {p.s, p.t}) {
      out.add(t.face);
      out.add(t.triangle);
    }
    add(out, p.meet_from);
    add(out, p.meet_to);
  } else {
    out.add(p.a);
    out.add(p.b);
  }
  out.add(p.end_cut - p.first_cut);
  for (std::uint32_t k = p.first_cut; k < p.end_cut; ++k) add(out, cuts[k]);
}

LinePiece piece_of(ByteReader& in, std::vector<NamedCut>& cuts) {
  LinePiece p;
  const auto flags = in.get<std::uint8_t>(), edge_class = in.get<std::uint8_t>();
  if (edge_class >= edge_class_count) ByteReader::refuse();
  p.is_ghost = (flags & ghost) != 0;
  p.is_behind = (flags & behind) != 0;
  p.starts_hidden = (flags & starts_hidden) != 0;
  p.is_only_bound = (flags & only_bound) != 0;
  p.goes_on_before = (flags & goes_on_before) != 0;
  p.goes_on_after = (flags & goes_on_after) != 0;
  p.edge_class = static_cast<EdgeClass>(edge_class);
  if ((flags & intersection) != 0) {
    for (NamedTriangle* t : {&p.s, &p.t}) *t = {in.get<std::uint32_t>(), in.get<std::uint32_t>()};
    p.meet_from = cut_of(in);
    p.meet_to = cut_of(in);
  } else {
    p.a = in.get<std::uint32_t>();
    p.b = in.get<std::uint32_t>();
  }
  p.first_cut = static_cast<std::uint32_t>(cuts.size());
  const auto count = in.get<std::uint32_t>();
  for (std::uint32_t k = 0; k < count; ++k) cuts.push_back(cut_of(in));
  p.end_cut = static_cast<std::uint32_t>(cuts.size());
  return p;
}

bool are_all_triangles(const Polygons& polygons) {
  for (std::size_t f = 0; f < polygons.size(); ++f)
    if (polygons[f].size() != 3) return false;
  return true;
}

/// Whether the numbers are ascending, and what stands for them is there.
void check(const ModelPart& part) {
  const auto ascend = [](const std::vector<std::uint32_t>& numbers) {
    for (std::size_t k = 1; k < numbers.size(); ++k)
      if (numbers[k - 1] >= numbers[k]) ByteReader::refuse();
  };
  ascend(part.points);
  ascend(part.faces);
  ascend(part.segments);
  const Polygons& polygons = part.model.polygons;
  const auto is_list_of = [](std::size_t size, std::size_t n) { return size == 0 || size == n; };
  const std::size_t faces = part.faces.size(), wires = part.segments.size();
  if (part.points.size() != part.model.points.size() || polygons.first.size() != faces + 1 ||
      !std::is_sorted(polygons.first.begin(), polygons.first.end()) || polygons.segments.size() != wires ||
      polygons.first.back() != polygons.corners.size() || !is_list_of(polygons.is_ghost.size(), faces) ||
      !is_list_of(part.model.face_colour.size(), faces) || !is_list_of(part.model.face_object.size(), faces) ||
      !is_list_of(part.model.face_material.size(), faces) || !is_list_of(part.model.segment_object.size(), wires))
    ByteReader::refuse();
}

}  // namespace

std::string bytes_of(const ModelPart& part) {
  ByteWriter out;
  const Polygons& polygons = part.model.polygons;
  out.add_ascending(part.points);
  out.add(part.model.points);
  out.add_ascending(part.faces);
  const bool are_triangles = are_all_triangles(polygons);
  out.add(static_cast<std::uint8_t>(are_triangles ? 1 : 0));
  if (!are_triangles) out.add_ascending(polygons.first);
  out.add(polygons.corners);
  out.add(polygons.is_ghost);
  out.add(part.model.face_colour);
  out.add(part.model.face_object);
  out.add(part.model.face_material);
  out.add_ascending(part.segments);
  out.add(polygons.segments);
  out.add(part.model.segment_object);
  return out.take();
}

ModelPart model_part_of(std::string_view bytes) {
  ByteReader in(bytes);
  ModelPart part;
  Polygons& polygons = part.model.polygons;
  in.get_ascending(part.points);
  in.get(part.model.points);
  in.get_ascending(part.faces);
  if (in.get<std::uint8_t>() != 0) {
    polygons.first.resize(part.faces.size() + 1);
    for (std::uint32_t f = 0; f < polygons.first.size(); ++f) polygons.first[f] = 3 * f;
  } else {
    polygons.first.clear();
    in.get_ascending(polygons.first);
  }
  in.get(polygons.corners);
  in.get(polygons.is_ghost);
  in.get(part.model.face_colour);
  in.get(part.model.face_object);
  in.get(part.model.face_material);
  in.get_ascending(part.segments);
  in.get(polygons.segments);
  in.get(part.model.segment_object);
  in.end();
  check(part);
  return part;
}

std::string bytes_of(const TilePart& part) {
  ByteWriter out;
  out.add(part.tile);
  out.add(part.pairs);
  out.add(std::string_view(bytes_of(part.model)));
  out.add(static_cast<std::uint64_t>(part.pieces.size()));
  for (const LinePiece& p : part.pieces) add(out, p, part.cuts);
  out.add(std::string_view(part.fragments));
  return out.take();
}

TilePart tile_part_of(std::string_view bytes) {
  ByteReader in(bytes);
  TilePart part;
  part.tile = in.get<std::uint32_t>();
  part.pairs = in.get<std::uint64_t>();
  part.model = model_part_of(in.text());
  const auto count = in.get<std::uint64_t>();
  for (std::uint64_t k = 0; k < count; ++k) part.pieces.push_back(piece_of(in, part.cuts));
  part.fragments = in.text();
  in.end();
  return part;
}

}  // namespace hsr::internal
