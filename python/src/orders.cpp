#include "python/src/orders.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>

#include "geometry/error.h"
#include "hsr/coordinates/coordinates.h"
#include "hsr/io/read/read.h"
#include "hsr/io/write/json.h"
#include "hsr/painter/bsp/bsp.h"
#include "hsr/painter/sort/depth_sort.h"
#include "hsr/painter/sort/z_sort.h"
#include "hsr/painter/verify/verify.h"
#include "hsr/surfaces/section.h"
#include "python/src/order_data.h"
#include "python/src/polygon_arrays.h"

namespace hsr::python {

namespace {

std::vector<PlacedPolygon> placed(const OrderData& data) {
  const py::gil_scoped_release release;
  return polygons(data.scene, data.order);
}

py::dict order_arrays(const OrderData& data) {
  std::vector<std::uint8_t> original;
  for (const OrderedPiece& piece : data.order.pieces)
    for (const PieceCorner& corner : data.order.corners_of(piece)) original.push_back(corner.original ? 1 : 0);
  py::dict all = arrays_of(placed(data));
  all["original"] = bool_array(original);
  return all;
}

/// Of the corners of a piece: x, y, z, "p/q" each.
std::vector<std::vector<std::string>> exact_corners(const OrderData& data, std::size_t i) {
  const PaintersOrder& order = data.order;
  require(i < order.pieces.size(), "the number of a piece is from 0 to less than their count");
  std::vector<std::vector<std::string>> corners;
  for (const PieceCorner& corner : order.corners_of(order.pieces[i])) {
    auto& numbers = corners.emplace_back();
    for (const Rational& x : exact_point(data.scene.mesh(), data.scene.view(), order.pieces[i].facet, corner))
      numbers.push_back(x.to_string());
  }
  return corners;
}

std::string json_of(const OrderData& data, bool exact) {
  const SceneView& scene = data.scene;
  std::optional<Section> caps;
  if (scene.view().has_section()) caps = section(scene);
  return order_json(scene.mesh(), scene.view(), data.order, exact ? Numbers::exact : Numbers::rounded, scene.options().coplanar,
                    caps ? &*caps : nullptr);
}

/// Of a view of the scene, without an order yet.
OrderData without_order(const std::shared_ptr<SceneData>& data, const cli::ViewOptions& view, Coplanar coplanar) {
  const Scene scene = data->scene();
  const cli::ChosenView chosen = cli::choose_view(view, scene.mesh(), data->model());
  return {data, chosen, SceneView(scene, chosen.view, {.coplanar = coplanar}), {}};
}

/// The tree of a scene, built once for all views.
class TreeData {
 public:
  TreeData(std::shared_ptr<SceneData> data, std::uint64_t seed) : data_(std::move(data)) {
    BspOptions options;
    options.seed = seed;
    tree_.emplace(data_->scene().mesh(), options);
  }
  OrderData order(const cli::ViewOptions& view, Coplanar coplanar) const {
    OrderData found = without_order(data_, view, coplanar);
    found.order = tree_->order(found.scene);
    return found;
  }
  std::size_t pieces() const { return tree_->pieces(); }

 private:
  std::shared_ptr<SceneData> data_;
  std::optional<BspTree> tree_;
};

std::shared_ptr<TreeData> build_tree(const std::shared_ptr<SceneData>& data, const py::dict& named) {
  const Arguments arguments(named);
  const auto seed = arguments.get<std::uint64_t>("seed", 1);
  std::shared_ptr<TreeData> tree;
  run(arguments.control(), [&](const Ticket&) { tree = std::make_shared<TreeData>(data, seed); });
  return tree;
}

std::shared_ptr<OrderData> order_by_tree(const std::shared_ptr<TreeData>& tree, const py::dict& named) {
  const Arguments arguments(named);
  const cli::ViewOptions view = arguments.view();
  const Coplanar coplanar = arguments.scene().which_coplanar();
  std::shared_ptr<OrderData> found;
  run(arguments.control(), [&](const Ticket&) { found = std::make_shared<OrderData>(tree->order(view, coplanar)); });
  return found;
}

std::shared_ptr<OrderData> find_order(const std::shared_ptr<SceneData>& data, const py::dict& named) {
  const Arguments arguments(named);
  const cli::ViewOptions view = arguments.view();
  const Coplanar coplanar = arguments.scene().which_coplanar();
  const std::string method = arguments.word("method", "depth-sort", {"depth-sort", "bsp", "z-sort", "naive"});
  DepthSortOptions options;
  options.classic = arguments.word("cuts", "few", {"few", "classic"}) == "classic";
  const auto seed = arguments.get<std::uint64_t>("seed", 1);
  std::shared_ptr<OrderData> found;
  run(arguments.control(), [&](const Ticket& ticket) {
    if (method == "bsp") {
      found = std::make_shared<OrderData>(TreeData(data, seed).order(view, coplanar));
      return;
    }
    found = std::make_shared<OrderData>(without_order(data, view, coplanar));
    options.stop = ticket.stop;
    found->may_be_wrong = method != "depth-sort";
    if (found->may_be_wrong)
      found->order = internal::z_sort(found->scene,
                                      method == "naive" ? internal::DepthKey::centroid : internal::DepthKey::farthest_vertex);
    else
      found->order = depth_sort(found->scene, options).order;
  });
  return found;
}

const char* name_of(Fault fault) {
  switch (fault) {
    case Fault::order:
      return "order";
    case Fault::piercing:
      return "piercing";
    case Fault::coplanar:
      return "coplanar";
    case Fault::covered_twice:
      break;
  }
  return "covered_twice";
}

py::tuple doubles_of(const std::array<Rational, 3>& p) {
  return py::make_tuple(p[0].to_double(), p[1].to_double(), p[2].to_double());
}

py::dict dict_of(const Verdict& v) {
  using namespace py::literals;
  py::list first;
  for (const Violation& violation : v.first) {
    const Witness& w = violation.witness;
    first.append(py::dict("earlier"_a = violation.earlier, "later"_a = violation.later, "fault"_a = name_of(violation.fault),
                          "image"_a = py::make_tuple(w.place[0].to_double(), w.place[1].to_double()),
                          "of_earlier"_a = doubles_of(w.of_earlier), "of_later"_a = doubles_of(w.of_later)));
  }
  return py::dict("ok"_a = v.is_correct(), "polygons"_a = v.polygons, "overlapping"_a = v.overlapping, "wrong"_a = v.wrong,
                  "piercing"_a = v.piercing, "covered_twice"_a = v.covered_twice, "first"_a = first,
                  "order_exists"_a = v.order_exists, "cycle"_a = v.cycle, "cuts_that_suffice"_a = v.cuts_that_suffice);
}

py::dict judge(const std::vector<PaintedPolygon>& far_to_near, const View& view, const Arguments& arguments,
               Coplanar coplanar) {
  VerifyOptions options;
  options.limit = arguments.get<std::size_t>("limit", options.limit);
  options.ties = coplanar;
  Verdict verdict;
  run(arguments.control(), [&](const Ticket&) { verdict = verify(far_to_near, view, options); });
  return dict_of(verdict);
}

py::dict verify_order(const std::shared_ptr<OrderData>& data, const py::dict& named) {
  return judge(painted_polygons(data->scene, data->order), data->scene.view(), Arguments(named),
               data->scene.options().coplanar);
}

/// The faces of a scene in their order.
py::dict verify_scene(const std::shared_ptr<SceneData>& data, const py::dict& named) {
  const Arguments arguments(named);
  const Model& model = data->model();
  std::vector<PaintedPolygon> far_to_near;
  for (std::size_t f = 0; f < model.polygons.size(); ++f) {
    PaintedPolygon& p = far_to_near.emplace_back();
    p.face = static_cast<std::uint32_t>(f);
    for (const std::uint32_t v : model.polygons[f])
      p.corners.push_back({model.points[v].x, model.points[v].y, model.points[v].z});
  }
  const View view = cli::choose_view(arguments.view(), data->scene().mesh(), model).view;
  return judge(far_to_near, view, arguments, arguments.scene().which_coplanar());
}

/// An order in a file, in the view that the file has.
py::dict verify_file(const std::string& path, const py::dict& named) {
  const PaintingFile file = read_order(path);
  if (!file.view) throw InputError(path + ": found no view, expected one in the file");
  return judge(file.far_to_near, *file.view, Arguments(named), file.coplanar.value_or(Coplanar::first));
}

}  // namespace

void add_orders(py::module_& module) {
  py::class_<OrderData, std::shared_ptr<OrderData>>(module, "OrderData")
      .def("arrays", &order_arrays)
      .def("exact", &exact_corners)
      .def("json", &json_of)
      .def("draw", &draw_order);
  py::class_<TreeData, std::shared_ptr<TreeData>>(module, "TreeData")
      .def_property_readonly("pieces", &TreeData::pieces)
      .def("order", &order_by_tree);
  module.def("tree", &build_tree);
  module.def("order", &find_order);
  module.def("verify_order", &verify_order);
  module.def("verify_scene", &verify_scene);
  module.def("verify_file", &verify_file);
}

}  // namespace hsr::python
