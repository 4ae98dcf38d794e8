#include <algorithm>
#include <string>
#include <string_view>

#include "geometry/error.h"
#include "hsr/tiles/byte_stream.h"
#include "hsr/tiles/tile_fragments.h"

namespace hsr::internal {

namespace {

/// How a line is given: what it is the image of, or that it is one of two that are known. Three bits.
enum class Given : std::uint8_t { edge, meet, near, side_of_tiles, same, before };

/// Few bits for numbers near 0, whatever their sign.
std::uint32_t zigzag(std::uint32_t difference) { return difference << 1U ^ (0U - (difference >> 31U)); }
std::uint32_t unzigzag(std::uint32_t code) { return code >> 1U ^ (0U - (code & 1U)); }

/// What was written or read last: numbers are told by how far they are from these.
struct Last {
  std::uint32_t point = 0, face = 0;
  MapLine line, before;  // of the last side, and of the one before it
};

class FragmentWriter {
 public:
  FragmentWriter(const Mesh& mesh, const Names& names, UsedParts& used) : mesh_(mesh), names_(names), used_(used) {}

  void begin(FacetId facet, std::size_t fragments) {
    add_triangle(first_triangle(facet));
    out_.add_small(static_cast<std::uint32_t>(fragments));
  }
  void add_count(std::size_t n) { out_.add_small(static_cast<std::uint32_t>(n)); }
  void add_line(const MapLine& line, bool reversed) {
    const Given given = given_as(line);
    out_.add(static_cast<std::uint8_t>(static_cast<unsigned>(given) | (reversed ? 8U : 0U)));
    add_numbers(line, given);
    last_.before = std::exchange(last_.line, line);
  }
  /// After the line that leads from it or to it.
  void add_point(const MapPoint& p) {
    if (p.is_vertex) {
      out_.add(std::uint8_t{0x80});
      add_vertex(p.vertex);
      return;
    }
    const Given l = given_near(p.l), m = given_near(p.m);
    out_.add(static_cast<std::uint8_t>(static_cast<unsigned>(l) | static_cast<unsigned>(m) << 3U));
    add_numbers(p.l, l);
    add_numbers(p.m, m);
  }
  std::string take() { return out_.take(); }

 private:
  Given given_as(const MapLine& line) const {
    switch (line.kind) {
      case MapLine::Kind::edge:
        return names_.side_of(line) ? Given::side_of_tiles : Given::edge;
      case MapLine::Kind::meet:
        return Given::meet;
      case MapLine::Kind::near:
        if (line.v == 0) return Given::near;
        break;
      case MapLine::Kind::fold:
        break;
    }
    throw PreconditionError("tiles: a view of several sections has cells of its own");
  }
  Given given_near(const MapLine& line) const {
    return line == last_.line ? Given::same : line == last_.before ? Given::before : given_as(line);
  }
  void add_numbers(const MapLine& line, Given given) {
    if (given == Given::edge) {
      add_vertex(VertexId(line.u));
      add_vertex(VertexId(line.v));
    }
    if (given == Given::meet || given == Given::near) add_triangle(TriangleId(line.u));
    if (given == Given::meet) add_triangle(TriangleId(line.v));
    if (given == Given::side_of_tiles) out_.add_small(*names_.side_of(line));
  }
  void add_vertex(VertexId v) {
    used_.add(v);
    const std::uint32_t n = names_.number(v);
    out_.add_small(zigzag(n - std::exchange(last_.point, n)));
  }
  void add_triangle(TriangleId t) {
    used_.add(t, mesh_);
    const NamedTriangle name = names_.name(t);
    out_.add_small(zigzag(name.face - std::exchange(last_.face, name.face)));
    out_.add_small(name.triangle);
  }

  const Mesh& mesh_;
  const Names& names_;
  UsedParts& used_;
  Last last_;
  ByteWriter out_;
};

class FragmentReader {
 public:
  FragmentReader(std::string_view bytes, const Names& names) : in_(bytes), names_(names) {}

  bool is_at_end() const { return in_.is_at_end(); }
  std::uint32_t count() { return in_.get_small(); }
  FacetId facet() { return FacetId(triangle().value); }
  MapSide line() {
    const auto head = in_.get<std::uint8_t>();
    MapSide side;
    side.line = line_of(static_cast<Given>(head & 7U));
    side.reversed = (head & 8U) != 0;
    last_.before = std::exchange(last_.line, side.line);
    return side;
  }
  MapPoint point() {
    const auto head = in_.get<std::uint8_t>();
    if (head == 0x80) return MapPoint::of_vertex(vertex());
    const MapLine l = line_of(static_cast<Given>(head & 7U));
    return MapPoint::crossing(l, line_of(static_cast<Given>(head >> 3U)));
  }

 private:
  MapLine line_of(Given given) {
    switch (given) {
      case Given::edge: {
        const VertexId a = vertex();
        return MapLine::edge(a, vertex());
      }
      case Given::meet: {
        const TriangleId s = triangle();
        return MapLine::meet(s, triangle());
      }
      case Given::near:
        return MapLine::near(triangle());
      case Given::side_of_tiles:
        return names_.side_line(names_.checked_side(in_.get_small()));
      case Given::same:
        return last_.line;
      case Given::before:
        return last_.before;
    }
    ByteReader::refuse();
  }
  VertexId vertex() { return names_.vertex(last_.point += unzigzag(in_.get_small())); }
  TriangleId triangle() {
    last_.face += unzigzag(in_.get_small());
    return names_.triangle({last_.face, in_.get_small()});
  }

  ByteReader in_;
  const Names& names_;
  Last last_;
};

}  // namespace

std::string bytes_of(const TileFragments& fragments, const Mesh& mesh, const Names& names, UsedParts& used) {
  FragmentWriter out(mesh, names, used);
  const auto& whole = fragments.whole;
  for (std::size_t i = 0, end = 0; i < whole.fragments.size(); i = end) {
    while (end < whole.fragments.size() && whole.fragments[end].facet == whole.fragments[i].facet) ++end;
    out.begin(whole.fragments[i].facet, end - i);
    for (std::size_t k = i; k < end; ++k) {
      const Fragment& f = whole.fragments[k];
      out.add_count(f.end_ring - f.first_ring);
      for (std::uint32_t r = f.first_ring; r < f.end_ring; ++r) {
        out.add_count(whole.rings[r].size());
        for (const MapCorner& c : whole.rings[r]) {
          out.add_line(c.line, c.reversed);
          out.add_point(c.at);
        }
      }
    }
  }
  for (std::size_t k = 0; k < fragments.facets.size(); ++k) {
    out.begin(fragments.facets[k], 0);
    out.add_count(fragments.sides[k].size());
    for (const MapSide& side : fragments.sides[k]) {
      out.add_line(side.line, side.reversed);
      out.add_point(side.from);
      out.add_point(side.to);
    }
  }
  return out.take();
}

TileFragments tile_fragments_of(std::string_view bytes, const Names& names) {
  FragmentReader in(bytes, names);
  TileFragments all;
  VisibleFragments& whole = all.whole;
  while (!in.is_at_end()) {
    const FacetId facet = in.facet();
    const std::uint32_t fragments = in.count();
    for (std::uint32_t k = 0; k < fragments; ++k) {
      const auto first = static_cast<std::uint32_t>(whole.rings.size());
      for (std::uint32_t rings = in.count(); rings > 0; --rings) {
        for (std::uint32_t corners = in.count(); corners > 0; --corners) {
          const MapSide side = in.line();
          whole.rings.push_back({in.point(), side.line, side.reversed});
        }
        whole.rings.end_row();
      }
      whole.fragments.push_back({facet, first, static_cast<std::uint32_t>(whole.rings.size())});
    }
    if (fragments > 0) continue;
    all.facets.push_back(facet);
    for (std::uint32_t sides = in.count(); sides > 0; --sides) {
      MapSide side = in.line();
      side.from = in.point();
      side.to = in.point();
      all.sides.push_back(side);
    }
    all.sides.end_row();
  }
  return all;
}

}  // namespace hsr::internal
