// Shared by the tests of gathered parts: a scene whose parts ranks draw, and the comparison with one process.
#pragma once
#include "cluster/testing/program_ranks.h"
#include "scene/secondary_scene.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace gluray::cluster::test {

inline scene::Snapshot gatheredPlates(int size = 64) {
  scene::Snapshot all = plates(size);
  all.number = 1;
  all.settings.gather = true;
  return all;
}

/// Grounds are placed below the bounds of meshes.
inline void setBounds(scene::Snapshot& all) {
  for (scene::Instance& instance : all.instances) {
    auto mesh = std::make_shared<scene::Mesh>(*instance.mesh);
    mesh->lower = mesh->upper = mesh->position(0);
    for (uint32_t vertex = 1; vertex < mesh->vertexCount; ++vertex)
      mesh->lower = glm::min(mesh->lower, glm::vec3(mesh->position(vertex))),
      mesh->upper = glm::max(mesh->upper, glm::vec3(mesh->position(vertex)));
    instance.mesh = std::move(mesh);
  }
}

struct GatherFixture : testing::Test {
  /// All ranks draw, and each shows it all.
  static void expectGathered(WorkerJob& job, ProgramRanks& programs, const scene::Snapshot& all, int ranks) {
    std::vector<int> everyone;
    for (int rank = 0; rank < ranks; ++rank) everyone.push_back(rank);
    const Image whole = expectedImage(partsOf(all, everyone, ranks));
    const std::vector<Image> images = programs.images(all);
    for (const Image& image : images) EXPECT_EQ(differing(image, whole), 0) << job.said();
    EXPECT_TRUE(programs.allByWorkers());
  }
  RuntimeFolder folder_;
  const std::string directory_ = folder_.directory();
  Image scratch_;
  scene::TraceCost cost_;
  std::string error_;
};

}  // namespace gluray::cluster::test
