// Meshes, materials and textures of an exported scene, each once: equal ones are shared. One thread.
#pragma once
#include "saved/export/arrays/mesh_arrays.h"
#include "saved/export/gather/exported_scene.h"

#include <functional>
#include <map>
#include <string>
#include <tuple>
#include <unordered_map>

namespace gluray::saved {

/// What sources of one array are for; the last part of their keys, kColors with more in the bits above.
enum SourceUse : size_t { kCoordinates, kPositions, kNormals, kIndices, kReversed, kColors, kSourceUses };

class SceneParts {
 public:
  explicit SceneParts(ExportedScene& scene) : scene_(scene) {}

  /// The source that `make` makes for what the key names, made once. Keys hold addresses, of arrays that the
  /// snapshots own, and what distinguishes sources of one array.
  using Key = std::tuple<const void*, const void*, size_t, size_t, size_t>;
  SourcePtr source(const Key& key, const std::function<SourcePtr()>& make);
  CornersPtr corners(const scene::MeshPtr&, const CornersPtr& made);
  const Extent& extent(const SourcePtr&);

  int texture(const ExportedTexture&);
  size_t material(const ExportedMaterial&);
  /// Sets the mesh's bounds.
  size_t mesh(ExportedMesh);

 private:
  using MeshKey = std::tuple<const void*, const void*, const void*, const void*, const void*, const void*,
                             const void*, size_t, MeshMode>;
  ExportedScene& scene_;
  std::map<Key, SourcePtr> sources_;
  std::map<SourcePtr, Extent> extents_;
  std::map<MeshKey, size_t> meshes_;
  std::map<const scene::Mesh*, CornersPtr> corners_;
  std::unordered_multimap<size_t, size_t> materials_;  // by the hash of their colour
};

/// Removes materials that no mesh has, and textures that no material has.
void dropUnused(ExportedScene&);

/// Whether a matrix is a translation, rotation and scaling, which nodes of every format can have.
bool isDecomposable(const glm::dmat4&);

/// A mesh whose vertices are transformed. `worldFromMesh` may be any invertible matrix.
ExportedMesh moved(const ExportedMesh&, const glm::dmat4& worldFromMesh);

}  // namespace gluray::saved
