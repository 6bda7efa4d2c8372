// Casting the rays of the volumes of scripts/bench volumes: 800x600 pixels, 256^3 floats.
#include "render/testing/test_volume_view.h"
#include "render/volumes/volume_tracer.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace {

using namespace gluray;

constexpr int kVoxels = 256;

enum class Field { dense, sparse };

/// A smooth field of which a third is empty.
float smoothAt(const glm::vec3& p) {
  return 0.5f + 0.5f * std::sin(5 * p.x) * std::cos(4 * p.y) * std::sin(3 * p.z);
}

/// Fourteen winding tubes.
class Tubes {
 public:
  Tubes() {
    std::mt19937 generator(1);
    std::uniform_real_distribution<float> place(-0.8f, 0.8f), phase(0, 6);
    for (Tube& tube : tubes_) tube = {place(generator), place(generator), phase(generator)};
  }
  float at(const glm::vec3& p) const {
    float most = 0;
    for (int i = 0; i < kTubes; ++i) {
      const Tube& tube = tubes_[i];
      const int along = i % 3;
      const float first = tube.first + 0.15f * std::sin(3 * p[along] + tube.phase);
      const float second = tube.second + 0.15f * std::cos(4 * p[along] + tube.phase);
      const glm::vec2 beside(p[(along + 1) % 3] - first, p[(along + 2) % 3] - second);
      const float square = glm::dot(beside, beside);
      if (square < 0.2f) most = std::max(most, std::exp(-square / 0.002f));
    }
    return most;
  }

 private:
  static constexpr int kTubes = 14;
  struct Tube {
    float first, second, phase;
  };
  Tube tubes_[kTubes];
};

std::shared_ptr<scene::VoxelGrid> made(Field field) {
  const auto grid = std::make_shared<scene::VoxelGrid>();
  grid->size = glm::ivec3(kVoxels);
  grid->values = std::make_unique<std::byte[]>(grid->bytes() + scene::VoxelGrid::kPadding);
  const Tubes tubes;
  std::byte* to = grid->values.get();
  for (int z = 0; z < kVoxels; ++z)
    for (int y = 0; y < kVoxels; ++y)
      for (int x = 0; x < kVoxels; ++x, to += sizeof(float)) {
        const glm::vec3 p = glm::vec3(x, y, z) * (2.0f / (kVoxels - 1)) - 1.0f;
        const float value = field == Field::dense ? smoothAt(p) : tubes.at(p);
        std::memcpy(to, &value, sizeof value);
      }
  return grid;
}

std::shared_ptr<const scene::VoxelGrid> gridOf(Field field) {
  static std::shared_ptr<const scene::VoxelGrid> grids[2];
  auto& grid = grids[static_cast<int>(field)];
  if (!grid) grid = made(field);
  return grid;
}

using Points = std::vector<std::pair<float, float>>;
/// The opacity of a step, whose length is `share` of the distance that the points are for.
scene::VolumeTable opacities(const Points& points, float share) {
  constexpr int kEntries = 1024;
  scene::VolumeTable table;
  for (int i = 0; i < kEntries; ++i) {
    const float at = static_cast<float>(i) / (kEntries - 1);
    size_t next = 1;
    while (next + 1 < points.size() && points[next].first < at) ++next;
    const auto& [x0, a0] = points[next - 1];
    const auto& [x1, a1] = points[next];
    table.values.push_back(1 - std::pow(1 - (a0 + (a1 - a0) * (at - x0) / (x1 - x0)), share));
  }
  return table;
}

/// From blue through white to red.
scene::VolumeTable colors() {
  constexpr int kEntries = 1024;
  scene::VolumeTable table;
  table.channels = 3;
  for (int i = 0; i < kEntries; ++i) {
    const float at = static_cast<float>(i) / (kEntries - 1);
    const float low = std::min(2 * at, 1.0f), high = std::min(2 - 2 * at, 1.0f);
    for (const float value : {low, std::min(low, high), high}) table.values.push_back(value);
  }
  return table;
}

scene::VolumeCast castOf(Field field, bool lit, float step) {
  test::VolumeBox box;
  box.voxels = glm::ivec3(kVoxels);
  test::VolumeCamera camera;
  const double azimuth = glm::radians(30.0), elevation = glm::radians(25.0), distance = 6.7;
  camera.eye = distance * glm::dvec3(std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                                     std::cos(azimuth) * std::cos(elevation));
  camera.up = {0, 1, 0}, camera.height = 0.408, camera.pixels = {800, 600};
  scene::VolumeCast cast;
  const float length = step * 2 / (kVoxels - 1);
  cast.view = test::viewOf(camera, box, length);
  cast.view.depth.assign(size_t{800} * 600, 1.0f);
  scene::Volume& volume = cast.volume;
  volume.grid = gridOf(field);
  volume.cellStep = glm::vec3(1.0f / kVoxels);
  volume.cellSpacing = glm::vec3(2.0f / (kVoxels - 1));
  const Points dense{{0, 0}, {0.35f, 0}, {0.6f, 0.04f}, {1, 0.1f}}, sparse{{0, 0}, {0.1f, 0}, {1, 0.5f}};
  volume.channels[0].opacity = opacities(field == Field::dense ? dense : sparse, length / 0.05f);
  volume.channels[0].color = colors();
  if (lit) {
    scene::VolumeMaterial& material = test::addViewerLight(volume);
    material.ambient = glm::vec3(0.1f), material.diffuse = glm::vec3(0.7f);
    material.specular = glm::vec3(0.2f), material.shininess = 10;
  }
  return cast;
}

void cast(benchmark::State& state, Field field, bool lit, float step) {
  const scene::VolumeCast cast = castOf(field, lit, step);
  Arena arena(1);
  render::VolumeTracer tracer;
  Image image;
  const char* why = "";
  tracer.trace(cast, arena, image, why);  // reads the voxels once
  for (auto _ : state)
    if (!tracer.trace(cast, arena, image, why)) return state.SkipWithError(why);
  state.SetItemsProcessed(state.iterations());
}

void add(const char* name, Field field, bool lit, float step) {
  benchmark::RegisterBenchmark(name, cast, field, lit, step)->Iterations(1)->Repetitions(5);
}

const bool added = [] {
  add("volume/dense", Field::dense, false, 1), add("volume/dense_lit", Field::dense, true, 1);
  add("volume/sparse", Field::sparse, false, 1), add("volume/sparse_lit", Field::sparse, true, 1);
  add("volume/dense_half", Field::dense, false, 0.5f), add("volume/dense_lit_half", Field::dense, true, 0.5f);
  add("volume/sparse_half", Field::sparse, false, 0.5f);
  add("volume/sparse_lit_half", Field::sparse, true, 0.5f);
  return true;
}();

}  // namespace
