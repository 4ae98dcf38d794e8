#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>

#include "geometry/mesh.h"
#include "geometry/predicates.h"
#include "hsr/face_labels.h"
#include "hsr/scene/tie_rule.h"
#include "hsr/view/view.h"

namespace hsr {

namespace internal {
class SceneParts;
class ViewParts;
}  // namespace internal

/// A stage that leaves out what the scene does not need. None changes a result.
enum class Stage : unsigned char {
  frame,         ///< edges that are outside the picture
  convex_body,   ///< all tests, where the scene is one convex body
  back_faces,    ///< the far sides of closed bodies
  hidden_tiles,  ///< what is hidden behind large faces
  far_faces,     ///< faces away from the edges that are asked for
};
constexpr std::size_t stage_count = 5;

/// Whether a stage is run; automatic, where it pays.
enum class When : unsigned char { automatic, always, never };

/// A stage that a result does without, and why; or what a stage saved.
struct LeftOut {
  std::string stage, why;
};

struct SceneOptions {
  Arithmetic arithmetic = Arithmetic::staged;  ///< the others are for comparison; they leave nothing out
  std::array<When, stage_count> stages = {};   ///< by Stage
  /// Whether lines that are hidden all along are wanted, too, with their classes. Without them an intersection that is certainly
  /// hidden is not looked for, and an edge that is hidden all along has its class by its own faces.
  bool hidden_lines = true;
  Coplanar coplanar = Coplanar::first;

  When& when(Stage stage) { return stages[static_cast<std::size_t>(stage)]; }
  When when(Stage stage) const { return stages[static_cast<std::size_t>(stage)]; }
};

/// The faces that are looked at, and what of them no view changes: which of them bound bodies, and which meet other than in
/// their edges, once a view has looked for all of these. The views of a sheet or of a turntable share it.
///
/// Immutable for all who see it; parts are made on first use, whatever thread asks. Copies are cheap and share everything.
class Scene {
 public:
  /// @throws PreconditionError if a list of labels is neither empty nor as long as the faces are many
  explicit Scene(Mesh mesh, FaceLabels labels = {});
  /// @pre `mesh` outlives every copy of the scene and of its views
  static Scene of(const Mesh& mesh, FaceLabels labels = {});

  const Mesh& mesh() const;
  const FaceLabels& labels() const;

 private:
  friend class SceneView;
  friend class internal::ViewParts;
  explicit Scene(std::shared_ptr<const internal::SceneParts> parts);

  std::shared_ptr<const internal::SceneParts> parts_;
};

/// A scene as one view sees it, prepared for every method: the projected points, the tree of the faces, closed bodies, the tiles
/// behind which everything is hidden, where faces pierce each other, the edges at which the number of layers changes.
///
/// Immutable; each part is made on first use, once, whatever thread asks first, and is then shared by visible lines, fragments,
/// painter's orders, pictures and checks. Copies are cheap and share the parts.
/// Cost: none by itself; see what uses it.
class SceneView {
 public:
  SceneView(const Scene& scene, const View& view, const SceneOptions& options = {});
  /// Of a scene that only this view looks at. @pre `mesh` outlives every copy
  SceneView(const Mesh& mesh, const View& view, const SceneOptions& options = {}) : SceneView(Scene::of(mesh), view, options) {}

  const Mesh& mesh() const { return scene_.mesh(); }
  const FaceLabels& labels() const { return scene_.labels(); }
  const View& view() const;
  const SceneOptions& options() const;
  /// What the methods share; not for users of the library.
  const internal::ViewParts& parts() const { return *parts_; }

 private:
  Scene scene_;
  std::shared_ptr<const internal::ViewParts> parts_;
};

}  // namespace hsr
