#include "tests/surfaces/checked_surfaces.h"

#include <algorithm>
#include <exception>

#include "geometry/error.h"
#include "hsr/check/sample_checks.h"
#include "hsr/raster/samples.h"
#include "hsr/surfaces/roberts_surfaces.h"
#include "hsr/surfaces/visible_fragments.h"
#include "hsr/symbols/constructions.h"
#include "tests/oracle/surfaces_oracle.h"

namespace hsr {

using namespace internal;

namespace {

/// At samples of the picture, many of them exactly on edges.
std::string differences_to_caster(const SceneView& scene, const VisibleFragments& found) {
  try {
    const SampleGrid grid = sample_grid(scene.view(), paper_rectangle(scene.mesh(), scene.view()), 24, 24);
    const FragmentCheck check = check_fragments(scene, found, grid);
    if (check.is_right()) return {};
    return std::to_string(check.wrong) + " samples differ from the caster, " + std::to_string(check.overlapping) + " overlap";
  } catch (const PreconditionError&) {
    return {};  // the eye in the plane of the samples, or samples that are no doubles
  } catch (const InputError&) {
    return {};  // a picture beyond all doubles
  }
}

}  // namespace

std::string wrong_fragments(const scenes::TestScene& scene, Coplanar coplanar) {
  try {
    const Mesh mesh = scene.mesh();
    const oracle::SurfacesOracle truth(mesh, scene.view, coplanar);
    std::string wrong;
    const VisibleFragments reference = roberts_surfaces(SceneView(mesh, scene.view, {.coplanar = coplanar}));
    for (const std::string& line : truth.differences(reference)) wrong += "roberts: " + line + "\n";
    const std::string expected = canonical(mesh, scene.view, reference);
    for (const When stages : {When::never, When::always}) {
      SceneOptions of_scene;
      of_scene.stages.fill(stages);
      of_scene.coplanar = coplanar;
      const SceneView view(mesh, scene.view, of_scene);
      const VisibleFragments found = visible_fragments(view);
      const std::string name = stages == When::always ? "fragments, stages" : "fragments";
      for (const std::string& line : truth.differences(found)) wrong.append(name).append(": ").append(line).append("\n");
      const std::string seen = differences_to_caster(view, found);
      if (!seen.empty()) wrong.append(name).append(": ").append(seen).append("\n");
      const std::string text = canonical(mesh, scene.view, found);
      if (expected != text) wrong.append("roberts:\n").append(expected).append(name).append(":\n").append(text);
      // From lines that were found for a drawing, and where hidden lines are not wanted.
      LineOptions every_class;
      every_class.classes.fill(true);
      every_class.diagonals = true;
      of_scene.hidden_lines = false;
      for (const SceneView& drawn : {view, SceneView(mesh, scene.view, of_scene)})
        for (const LineMethod method : {LineMethod::roberts, LineMethod::appel}) {
          every_class.method = method;
          const VisibleLines lines = visible_lines(drawn, every_class);
          if (canonical(mesh, scene.view, visible_fragments(drawn, {.lines = &lines})) != expected)
            wrong.append(name).append(": others from given lines\n");
        }
    }
    return wrong;
  } catch (const std::exception& e) {
    return std::string("exception: ") + e.what() + "\n";
  }
}

std::string canonical(const Mesh& mesh, const View& view, const VisibleFragments& fragments) {
  std::vector<std::string> all;
  for (const Fragment& f : fragments.fragments) {
    std::vector<std::string> rings;
    for (std::uint32_t r = f.first_ring; r < f.end_ring; ++r) {
      std::vector<std::array<Rational, 3>> ring;
      for (const MapCorner& c : fragments.rings[r]) ring.push_back(exact_point(mesh, view, f.facet, c.at));
      std::string text;
      for (const auto& p : ring) text += " (" + p[0].to_string() + ", " + p[1].to_string() + ", " + p[2].to_string() + ")";
      rings.push_back(text);
    }
    std::string text = "triangle " + std::to_string(f.facet.value) + ":";
    for (const std::string& ring : rings) text += ring + ";";
    all.push_back(text);
  }
  std::string out;
  for (const std::string& line : all) out += line + "\n";
  return out;
}

std::string areas(const scenes::TestScene& scene, Coplanar coplanar) {
  const Mesh mesh = scene.mesh();
  const VisibleFragments found = visible_fragments(SceneView(mesh, scene.view, {.coplanar = coplanar}));
  const std::vector<Rational> of_fragment = visible_areas(mesh, scene.view, found);
  std::vector<Rational> of_face(mesh.faces.size());
  for (std::size_t k = 0; k < of_fragment.size(); ++k) {
    Rational& sum = of_face[mesh.face_of[first_triangle(found.fragments[k].facet)].value];
    sum = sum + of_fragment[k];
  }
  std::string text;
  for (const Rational& a : of_face) text += (text.empty() ? "" : " ") + (a == Rational() ? std::string("-") : a.to_string());
  return text;
}

}  // namespace hsr
