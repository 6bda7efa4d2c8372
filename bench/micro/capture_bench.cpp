// Cost of vertices on the program's thread: the engine's functions, their stream, and recognising a run.
#include "bench/micro/micro_mesh.h"
#include "gl/capture/vertex_stream.h"
#include "tests/support/traced_context.h"

#include <benchmark/benchmark.h>

#include <chrono>

namespace {

using namespace gluray;

/// Accepts every batch and does nothing with it.
class NoPresenter final : public gl::Presenter {
 public:
  gl::PresentResult present(const gl::RealGl&, const scene::SnapshotPtr&,
                            const gl::PresentTarget&) noexcept override {
    ++batches;
    return {.outcome = gl::PresentResult::traced};
  }
  bool supports(const gl::RealGl&, bool, std::string&) noexcept override { return true; }
  void forget(const gl::RealGl&) noexcept override {}
  static inline int batches = 0;
};

/// glNormal3fv and glVertex3fv as the door calls them in the engine.
void engineCalls(benchmark::State& state) {
  const test::TracedContext traced({}, test::TracedContext::tracing(), std::make_unique<NoPresenter>());
  const gl::RealGl& gl = traced.gl();
  const std::vector<bench::Vertex> sent = bench::corners(bench::kMicroTriangles);
  gl.Enable(GL_DEPTH_TEST);
  NoPresenter::batches = 0;
  for (auto _ : state) {
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.Begin(GL_TRIANGLES);
    const auto start = std::chrono::steady_clock::now();
    for (size_t i = 0; i < sent.size(); i += 2) {
      gl.Normal3fv(&sent[i].x);
      gl.Vertex3fv(&sent[i + 1].x);
    }
    state.SetIterationTime(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    gl.End();
    gl.Finish();
  }
  if (NoPresenter::batches < state.iterations()) state.SkipWithError("the calls were not captured");
  state.SetItemsProcessed(state.iterations() * int64_t(sent.size()));
}
BENCHMARK(engineCalls)->Name("engine/vertex_call")->UseManualTime()->Iterations(10)->Repetitions(5);

void fill(gl::VertexStream& stream, const std::vector<bench::Vertex>& sent) {
  stream.start(gl::bit(gl::kPosition) | gl::bit(gl::kNormal), gl::initialSlotValues());
  stream.begin(GL_TRIANGLES);
  for (size_t i = 0; i < sent.size(); i += 2) {
    stream.set(gl::kNormal, &sent[i].x);
    if (stream.hasRoom())
      stream.vertex(sent[i + 1].x, sent[i + 1].y, sent[i + 1].z);
    else
      stream.vertexSlow(sent[i + 1].x, sent[i + 1].y, sent[i + 1].z, 1);
  }
  stream.end();
}

/// Captures normals and vertices into reused memory.
void capture(benchmark::State& state) {
  const std::vector<bench::Vertex> sent = bench::corners(bench::kMicroTriangles);
  gl::VertexStream stream;
  fill(stream, sent);
  for (auto _ : state) {
    fill(stream, sent);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * int64_t(bench::kMicroTriangles));
}
BENCHMARK(capture)->Name("capture/immediate")->Unit(benchmark::kMillisecond)->UseRealTime()->Repetitions(5);

/// Checks by hash whether a run equals that of the last frame.
void unchanged(benchmark::State& state) {
  gl::VertexStream stream;
  fill(stream, bench::corners(bench::kMicroTriangles));
  for (auto _ : state) benchmark::DoNotOptimize(stream.captured().hash());
  state.SetItemsProcessed(state.iterations() * int64_t(bench::kMicroTriangles));
}
BENCHMARK(unchanged)->Name("unchanged/hash")->Unit(benchmark::kMillisecond)->UseRealTime()->Repetitions(5);

}  // namespace
