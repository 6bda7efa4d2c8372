// Round shapes as meshes of an exported scene: nodes of shared meshes, or merged ones. One thread.
#pragma once
#include "saved/export/arrays/round_shapes.h"
#include "saved/export/gather/scene_parts.h"

#include <array>
#include <vector>

namespace gluray::saved {

struct PlacedMesh {
  ExportedMesh mesh;
  glm::dmat4 worldFromMesh{1};
};

class ShapeMeshes {
 public:
  explicit ShapeMeshes(SceneParts& parts) : parts_(parts) {}
  /// `placed`: from the shapes' space to the world. `mayShare`: nodes of shared meshes may be made. Throws
  /// std::runtime_error where the shapes are too many for one mesh.
  std::vector<PlacedMesh> of(std::vector<RoundShape> shapes, const ExportedMaterial&,
                             const glm::dmat4& placed, bool mayShare);

 private:
  const ExportedMesh& unitMesh(RoundForm);
  std::vector<PlacedMesh> mergedMeshes(std::vector<RoundShape>, ExportedMaterial, const glm::dmat4& placed);

  SceneParts& parts_;
  std::array<ExportedMesh, kRoundForms> units_;
};

}  // namespace gluray::saved
