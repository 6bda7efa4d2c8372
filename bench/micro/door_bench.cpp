// gluray-bench-door: cost of a call of glNormal3fv and glVertex3fv in a program. The program knows nothing of
// GLuRay; scripts/bench micro runs it with and without gluray.
#include "bench/client/window.h"
#include "bench/micro/micro_mesh.h"

#include <GL/gl.h>
#include <benchmark/benchmark.h>

#include <chrono>

namespace {

using namespace gluray::bench;

void vertexCalls(benchmark::State& state) {
  static Window window(256);
  static const std::vector<Vertex> sent = corners(kMicroTriangles);
  glEnable(GL_DEPTH_TEST);
  glLoadIdentity();
  glScalef(1.0f / 200, 1.0f / 200, 1.0f / 200);
  for (auto _ : state) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glBegin(GL_TRIANGLES);
    const auto start = std::chrono::steady_clock::now();
    for (size_t i = 0; i < sent.size(); i += 2) {
      glNormal3fv(&sent[i].x);
      glVertex3fv(&sent[i + 1].x);
    }
    state.SetIterationTime(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    glEnd();
    window.swapAndFinish();  // drawing is measured elsewhere
  }
  state.SetItemsProcessed(state.iterations() * int64_t(sent.size()));
  state.SetLabel(reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
}
BENCHMARK(vertexCalls)->Name("door/vertex_call")->UseManualTime()->Iterations(10)->Repetitions(5);

}  // namespace

BENCHMARK_MAIN();
