// Surfaces with painted edges, for tests.
#pragma once
#include "accel/testing/test_scene.h"
#include "scene/snapshot.h"

#include <cstdint>
#include <vector>

namespace gluray::test {

/// Paints red edges of `width` pixels on the snapshot's first instance; `flags` as Instance::triangleEdges.
/// Its triangles grow.
inline void paintEdges(scene::Snapshot& s, const std::vector<uint8_t>& flags, float width) {
  s.instances[0].triangleEdges = makeAttribute(flags, scene::Format::bits8);
  scene::FragmentShading& f = s.shadings[0].fragment;
  f.model = scene::FragmentShading::Model::unlit;
  f.edges = true;
  f.edgeWidth = width;
  f.edgeColor = {1, 0, 0};
}

}  // namespace gluray::test
