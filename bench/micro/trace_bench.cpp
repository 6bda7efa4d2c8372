// Building acceleration structures, and tracing and shading a frame of 1024x1024 pixels.
#include "bench/micro/micro_mesh.h"
#include "bench/render/wavelet_snapshot.h"
#include "frame/renderer.h"

#include <benchmark/benchmark.h>

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
    frame::Renderer renderer;  // knows no structure yet
    frame::FrameStatistics statistics;
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

void trace(benchmark::State& state) {
  scene::Snapshot s = snapshot(BvhQuality::full);
  frame::Renderer renderer;
  frame::FrameStatistics statistics;
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
