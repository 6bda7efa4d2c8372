// Scenes at which denoisers are compared: an isosurface, balls, thin tubes, a landscape.
#pragma once
#include "bench/data/triangle_mesh.h"
#include "scene/snapshot.h"

#include <memory>
#include <string>
#include <vector>

namespace gluray::bench {

/// A mesh and a snapshot that reads it.
struct RefineScene {
  std::unique_ptr<const TriangleMesh> mesh;
  scene::Snapshot snapshot;
};

const std::vector<std::string>& refineSceneNames();

/// The scene of that name, in the middle `size` x `size` pixels of an image of kImageSize. `wavelet` has one
/// colour and about `millionTriangles` of them; the others have a colour for each vertex: of each ball, from
/// red to blue along each tube, and a colour map with narrow bands over the landscape. Throws
/// std::runtime_error on an unknown name.
RefineScene refineScene(const std::string& name, double millionTriangles, int size);

}  // namespace gluray::bench
