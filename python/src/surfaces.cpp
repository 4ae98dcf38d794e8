#include "python/src/surfaces.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>

#include "hsr/check/sample_checks.h"
#include "hsr/cli/page_arguments.h"
#include "hsr/coordinates/coordinates.h"
#include "hsr/io/write/png.h"
#include "hsr/raster/caster.h"
#include "hsr/surfaces/roberts_surfaces.h"
#include "hsr/surfaces/section.h"
#include "hsr/surfaces/visible_fragments.h"
#include "python/src/arguments.h"
#include "python/src/polygon_arrays.h"

namespace hsr::python {

using namespace internal;

namespace {

/// A scene as the arguments ask for it.
struct Seen {
  Scene scene;
  cli::ChosenView chosen;
  SceneView view;

  Seen(SceneData& data, const cli::ViewOptions& options, Coplanar coplanar)
      : scene(data.scene()),
        chosen(cli::choose_view(options, scene.mesh(), data.model())),
        view(scene, chosen.view, {.coplanar = coplanar}) {}

  /// The picture of the command: what the field of view frames, or all.
  SampleGrid samples(const PixelSize& size) const {
    DrawingOptions options;
    options.field_of_view = chosen.field_of_view;
    return cli::samples_for(chosen.view, scene.mesh(), options, size.width, size.height);
  }
};

VisibleFragments fragments_of(const SceneView& view, const std::string& method, const Ticket& ticket) {
  FragmentOptions options;
  options.progress = ticket.progress;
  options.stop = ticket.stop;
  return method == "roberts" ? roberts_surfaces(view, options) : visible_fragments(view, options);
}

py::dict find_fragments(const std::shared_ptr<SceneData>& data, const py::dict& named) {
  const Arguments arguments(named);
  const cli::ViewOptions options = arguments.view();
  const Coplanar coplanar = arguments.scene().which_coplanar();
  const std::string method = arguments.word("method", "auto", {"auto", "roberts"});
  std::vector<PlacedPolygon> found;
  std::vector<double> areas;
  run(arguments.control(), [&](const Ticket& ticket) {
    const Seen seen(*data, options, coplanar);
    const VisibleFragments fragments = fragments_of(seen.view, method, ticket);
    ticket.check();
    found = polygons(seen.view, fragments);
    for (const Rational& area : visible_areas(seen.scene.mesh(), seen.chosen.view, fragments))
      areas.push_back(area.to_double());
  });
  py::dict all = arrays_of(found);
  all["area"] = array_of(std::move(areas));
  return all;
}

/// Caps as fragments are: face, ring_offsets, offsets, points and image; and object, exact_points as texts, open_outlines.
py::dict find_section(const std::shared_ptr<SceneData>& data, const py::dict& named) {
  const Arguments arguments(named);
  const cli::ViewOptions options = arguments.view();
  std::vector<std::int64_t> object, face, plane, ring_offsets = {0}, offsets = {0};
  std::vector<double> points, at;
  std::vector<std::string> exact;
  std::size_t open_outlines = 0;
  run(arguments.control(), [&](const Ticket&) {
    const Seen seen(*data, options, Coplanar::first);
    const Section found = section(seen.view);
    open_outlines = found.open_outlines;
    const PaperImage image(seen.chosen.view);
    for (const SectionCap& cap : found.caps) {
      object.push_back(cap.object);
      face.push_back(cap.face.value);
      plane.push_back(cap.plane);
      for (std::uint32_t r = cap.first_ring; r < cap.end_ring; ++r) {
        for (const auto& p : found.rings[r]) {
          for (const Rational& x : p) {
            points.push_back(x.to_double());
            exact.push_back(x.to_string());
          }
          for (const Rational& x : image(p)) at.push_back(x.to_double());
        }
        offsets.push_back(static_cast<std::int64_t>(points.size() / 3));
      }
      ring_offsets.push_back(static_cast<std::int64_t>(offsets.size() - 1));
    }
  });
  const auto n = static_cast<py::ssize_t>(points.size() / 3);
  py::dict all;
  all["object"] = array_of(std::move(object));
  all["face"] = array_of(std::move(face));
  all["plane"] = array_of(std::move(plane));
  all["ring_offsets"] = array_of(std::move(ring_offsets));
  all["offsets"] = array_of(std::move(offsets));
  all["points"] = array_of(std::move(points), {n, 3});
  all["image"] = array_of(std::move(at), {n, 2});
  all["exact"] = std::move(exact);
  all["open_outlines"] = open_outlines;
  return all;
}

PixelSize size_of(const Arguments& arguments) {
  return arguments.has("size") ? parse_size(arguments.get<std::string>("size", {})) : PixelSize{1024, 1024};
}

py::dict check_fragments_of(const std::shared_ptr<SceneData>& data, const py::dict& named) {
  const Arguments arguments(named);
  const cli::ViewOptions options = arguments.view();
  const Coplanar coplanar = arguments.scene().which_coplanar();
  const PixelSize size = size_of(arguments);
  FragmentCheck check;
  run(arguments.control(), [&](const Ticket& ticket) {
    const Seen seen(*data, options, coplanar);
    const VisibleFragments fragments = fragments_of(seen.view, "auto", ticket);
    ticket.check();
    check = cli::on_samples([&] { return check_fragments(seen.view, fragments, seen.samples(size)); });
  });
  const auto number = [](FaceId f) { return f.is_valid() ? std::int64_t{f.value} : -1; };
  py::list first;
  for (const WrongSample& w : check.first_wrong) first.append(py::make_tuple(w.i, w.j, number(w.painted), number(w.cast)));
  using namespace py::literals;
  return py::dict("samples"_a = check.samples, "covered"_a = check.covered, "wrong"_a = check.wrong,
                  "overlapping"_a = check.overlapping, "first_wrong"_a = first);
}

py::array cast_faces(const std::shared_ptr<SceneData>& data, const py::dict& named) {
  const Arguments arguments(named);
  const cli::ViewOptions options = arguments.view();
  const Coplanar coplanar = arguments.scene().which_coplanar();
  const PixelSize size = size_of(arguments);
  std::vector<std::int64_t> faces;
  run(arguments.control(), [&](const Ticket&) {
    const Seen seen(*data, options, coplanar);
    const CastImage image = cli::on_samples([&] { return cast(seen.view, seen.samples(size)); });
    for (int j = 0; j < size.height; ++j)
      for (int i = 0; i < size.width; ++i) {
        const FaceId f = image.face(seen.scene.mesh(), i, j);
        faces.push_back(f.is_valid() ? std::int64_t{f.value} : -1);
      }
  });
  return array_of(std::move(faces), {size.height, size.width});
}

}  // namespace

void add_surfaces(py::module_& module) {
  module.def("fragments", &find_fragments);
  module.def("section", &find_section);
  module.def("check", &check_fragments_of);
  module.def("cast", &cast_faces);
}

}  // namespace hsr::python
