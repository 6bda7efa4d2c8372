// Building acceleration structures, and tracing and shading a frame of 1024x1024 pixels.
#include "bench/micro/micro_mesh.h"
#include "bench/render/wavelet_snapshot.h"
#include "frame/tracing/renderer.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <vector>

namespace {

using namespace gluray;

scene::Snapshot snapshot(BvhQuality quality) {
  scene::Snapshot s = bench::waveletSnapshot(bench::microMesh());
  s.settings.bvh = quality;
  bench::lookFrom(s, bench::orbitPose(0, 0));
  return s;
}

void build(benchmark::State& state, BvhQuality quality) {
  const scene::Snapshot s = snapshot(quality);
  Image image;
  std::string error;
  for (auto _ : state) {
    frame::Renderer renderer;  // has no structure yet
    scene::TraceCost statistics;
    if (!renderer.render(s, image, statistics, error)) return state.SkipWithError(error.c_str());
    state.SetIterationTime(statistics.buildSeconds);
  }
  state.SetItemsProcessed(state.iterations() * int64_t(bench::microMesh().triangleCount()));
}
BENCHMARK_CAPTURE(build, fast, BvhQuality::fast)
    ->Name("build/fast")
    ->UseManualTime()
    ->Iterations(3)
    ->Repetitions(5);
BENCHMARK_CAPTURE(build, full, BvhQuality::full)
    ->Name("build/full")
    ->UseManualTime()
    ->Iterations(3)
    ->Repetitions(5);

/// The same triangles at other places, with room behind for Embree's wide loads.
scene::MeshPtr moved(const scene::Mesh& mesh, float time) {
  auto positions = std::make_shared<std::vector<glm::vec3>>(mesh.vertexCount + 2);
  for (uint32_t v = 0; v < mesh.vertexCount; ++v) {
    const glm::vec3 p(scene::fetch(mesh.positions, v));
    (*positions)[v] = p + 4.0f * glm::vec3(std::sin(0.02f * p.y + time), std::sin(0.03f * p.z + time), 0);
  }
  auto result = std::make_shared<scene::Mesh>(mesh);
  result->geometryId = hashBytes(positions->data(), positions->size() * sizeof(glm::vec3));
  result->positions.data = reinterpret_cast<const std::byte*>(positions->data());
  result->positions.stride = sizeof(glm::vec3);
  result->positions.owner = std::move(positions);
  return result;
}

/// A moving mesh: the cost of its structure in each frame.
void follow(benchmark::State& state) {
  scene::Snapshot s = snapshot(BvhQuality::automatic);
  const scene::MeshPtr mesh = s.instances[0].mesh;
  frame::Renderer renderer;
  scene::TraceCost statistics;
  Image image;
  std::string error;
  int step = 0;
  const auto next = [&] {
    s.instances[0].mesh = moved(*mesh, 0.05f * static_cast<float>(step++));
    return renderer.render(s, image, statistics, error);
  };
  for (int i = 0; i < 6; ++i) next();  // until GLuRay treats it as moving
  for (auto _ : state) {
    if (!next()) return state.SkipWithError(error.c_str());
    state.SetIterationTime(statistics.buildSeconds);
  }
  state.SetItemsProcessed(state.iterations() * int64_t(mesh->triangleCount));
}
BENCHMARK(follow)->Name("build/moving")->UseManualTime()->Iterations(12)->Repetitions(5);

void trace(benchmark::State& state) {
  scene::Snapshot s = snapshot(BvhQuality::full);
  frame::Renderer renderer;
  scene::TraceCost statistics;
  Image image;
  std::string error;
  if (!renderer.render(s, image, statistics, error)) return state.SkipWithError(error.c_str());
  constexpr int kPoses = 24;
  int pose = 0;
  for (auto _ : state) {
    bench::lookFrom(s, bench::orbitPose(pose++ % kPoses, kPoses));
    if (!renderer.render(s, image, statistics, error)) return state.SkipWithError(error.c_str());
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(trace)->Name("trace/frame")->UseRealTime()->Iterations(24)->Repetitions(5);

}  // namespace
