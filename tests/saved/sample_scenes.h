// Small scenes of every kind that files can hold, for read_back.py.
#pragma once
#include "scene/snapshot.h"

#include <string>
#include <vector>

namespace gluray::test {

struct SampleScene {
  std::string name;
  scene::SnapshotPtr snapshot;
};

/// Their honest look (setting look) is what the files show.
std::vector<SampleScene> sampleScenes();

/// A grid of triangles with normals and colours of bytes, two for each cell.
scene::SnapshotPtr largeScene(uint32_t triangles);

}  // namespace gluray::test
