#include "hsr/painter/order_in_cells.h"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/error.h"
#include "geometry/near_value.h"
#include "hsr/painter/piece_clipper.h"
#include "hsr/scene/view_parts.h"

namespace hsr::internal {

namespace {

class CellOrders {
 public:
  explicit CellOrders(const SceneView& scene) : mesh_(scene.mesh()), view_(scene.view()), clipper_(scene.parts().projected()) {}

  void add(const ViewParts::Cell& cell, const PaintersOrder& order) {
    borders_.clear();
    for (const CellSide& side : cell.cell.sides)
      borders_.push_back(clipper_.border({Cut::Kind::fold, 0, side.u, side.v}, side.kept));
    if (view_.far) borders_.push_back(clipper_.border(Cut{Cut::Kind::near}.by_plane(View::far_number), Sign::negative));
    std::vector<std::uint32_t> place;  // where each piece, or the next that is left, is now
    for (const OrderedPiece& piece : order.pieces) {
      place.push_back(static_cast<std::uint32_t>(all_.pieces.size()));
      add_piece(piece.facet, order.corners_of(piece), cell.cell.plane);
    }
    place.push_back(static_cast<std::uint32_t>(all_.pieces.size()));
    for (const OrderedWire& wire : order.wires) add_wire(wire, place[wire.before]);
    all_.decisions += order.decisions;
  }

  PaintersOrder take() {
    check_countable(all_.corners.size(), "corners of a painting order");
    std::stable_sort(all_.wires.begin(), all_.wires.end(), [](const OrderedWire& x, const OrderedWire& y) {
      return std::tie(x.before, x.edge, x.from) < std::tie(y.before, y.edge, y.from);
    });
    all_.decisions += clipper_.decisions();
    return std::move(all_);
  }

 private:
  void add_piece(FacetId facet, std::span<const PieceCorner> given, std::uint8_t plane) {
    std::vector<PieceCorner> corners;
    for (PieceCorner c : given) {
      c.a = c.a.by_plane(plane);
      c.b = c.b.by_plane(plane);
      c.side = c.side.by_plane(plane);
      corners.push_back(c);
    }
    for (const PieceClipper::Border& border : borders_)
      if (!clipper_.keep(border, facet, corners)) return;
    OrderedPiece piece{facet, static_cast<std::uint32_t>(all_.corners.size()), 0};
    all_.corners.insert(all_.corners.end(), corners.begin(), corners.end());
    piece.end_corner = static_cast<std::uint32_t>(all_.corners.size());
    all_.pieces.push_back(piece);
  }

  /// As few as wires are: in rationals.
  void add_wire(OrderedWire wire, std::uint32_t before) {
    wire.before = before;
    const RationalVector a = rational(mesh_.points[mesh_.edges[wire.edge].a]),
                         b = rational(mesh_.points[mesh_.edges[wire.edge].b]);
    const auto value = [&](const PieceClipper::Border& border, const RationalVector& p) -> Rational {
      const auto at = [&](std::uint8_t k) { return near_value(view_.cutting_plane(k), p); };
      if (border.cut.kind == Cut::Kind::near) return at(border.cut.plane());
      const auto at_eye = [&](std::uint8_t k) {
        const Plane plane = view_.cutting_plane(k);
        const RationalVector e = rational(view_.viewpoint.at);
        return view_.is_perspective() ? near_value(plane, e) : dot(e, rational(plane.normal));
      };
      const auto u = static_cast<std::uint8_t>(border.cut.u), v = static_cast<std::uint8_t>(border.cut.v);
      if (u == v) return at(u);
      return at(u) * at_eye(v) - at_eye(u) * at(v);
    };
    for (const PieceClipper::Border& border : borders_) {
      const Rational at_a = value(border, a), at_b = value(border, b), rise = at_b - at_a;
      const Sign way = rise.sign() * border.kept;
      if (way == Sign::zero) {
        if (at_a.sign() * border.kept == Sign::negative) return;
        continue;
      }
      const Rational t = -at_a / rise;
      if (way == Sign::positive)
        wire.from = std::max(wire.from, t);
      else
        wire.to = std::min(wire.to, t);
    }
    if (wire.from < wire.to) all_.wires.push_back(wire);
  }

  const Mesh& mesh_;
  const View& view_;
  PieceClipper clipper_;
  std::vector<PieceClipper::Border> borders_;
  PaintersOrder all_;
};

}  // namespace

PaintersOrder order_in_cells(const SceneView& scene, const std::function<PaintersOrder(const ViewParts::Cell&)>& order_of) {
  CellOrders orders(scene);
  for (const ViewParts::Cell& cell : scene.parts().cells()) orders.add(cell, order_of(cell));
  return orders.take();
}

}  // namespace hsr::internal
