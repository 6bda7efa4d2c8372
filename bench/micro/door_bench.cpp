// gluray-bench-door: costs of calls in a program: glNormal3fv and glVertex3fv, and small draws of each kind
// with the calls between them. The program knows nothing of GLuRay; scripts/bench micro runs it with and
// without gluray.
#include "bench/client/window.h"
#include "bench/micro/micro_mesh.h"

#include <GL/gl.h>
#include <benchmark/benchmark.h>
#include <time.h>

#include <array>
#include <chrono>
#include <string>

namespace {

using namespace gluray::bench;

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Window& window() {
  static Window shown(256);
  return shown;
}

void vertexCalls(benchmark::State& state) {
  window();
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
    state.SetIterationTime(secondsSince(start));
    glEnd();
    window().swapAndFinish();  // drawing is measured elsewhere
  }
  state.SetItemsProcessed(state.iterations() * int64_t(sent.size()));
  state.SetLabel(reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
}
BENCHMARK(vertexCalls)->Name("door/vertex_call")->UseManualTime()->Iterations(10)->Repetitions(5);

/// CPU time of this thread.
double threadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

constexpr int kDraws = 2000;  // a frame
using Normals = std::array<GLfloat, 6>;
// Two triangles: a normal and a position each corner.
constexpr std::array<Normals, 6> kCorners = {{{0, 0, 1, 0, 0, 0},
                                              {0, 0, 1, 1, 0, 0},
                                              {0, 0, 1, 1, 1, 0},
                                              {0, 0, 1, 0, 0, 0},
                                              {0, 0, 1, 1, 1, 0},
                                              {0, 0, 1, 0, 1, 0}}};

void drawArrays() { glDrawArrays(GL_TRIANGLES, 0, GLsizei{kCorners.size()}); }

void drawPrimitive() {
  glBegin(GL_TRIANGLES);
  for (const Normals& corner : kCorners) glNormal3fv(corner.data()), glVertex3fv(corner.data() + 3);
  glEnd();
}

void callList() { glCallList(1); }

/// CPU time of kDraws draws without the work that waits for the end of the frame.
/// Each gets a colour and a place: surfaces at one place would be left to the real OpenGL.
void smallDraws(benchmark::State& state, void (*draw)()) {
  window();
  glEnable(GL_DEPTH_TEST), glEnable(GL_COLOR_MATERIAL), glEnable(GL_LIGHTING), glEnable(GL_LIGHT0);
  glNormalPointer(GL_FLOAT, sizeof(Normals), kCorners[0].data());
  glVertexPointer(3, GL_FLOAT, sizeof(Normals), kCorners[0].data() + 3);
  glEnableClientState(GL_NORMAL_ARRAY), glEnableClientState(GL_VERTEX_ARRAY);
  glNewList(1, GL_COMPILE), drawPrimitive(), glEndList();
  for (auto _ : state) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    const double start = threadSeconds();
    for (int i = 0; i < kDraws; ++i) {
      glColor3ub(GLubyte(i), GLubyte(i >> 4), 200);
      glPushMatrix(), glTranslatef(GLfloat(i) / kDraws, 0, 0);
      draw();
      glPopMatrix();
    }
    glPushMatrix(), glPopMatrix();  // the last draws have ended
    state.SetIterationTime(threadSeconds() - start);
    window().swapAndFinish();
  }
  state.SetItemsProcessed(state.iterations() * kDraws);
}

void measureSmallDraws(const char* name, void (*draw)()) {
  benchmark::RegisterBenchmark((std::string("door/small_") + name).c_str(),
                               [=](benchmark::State& state) { smallDraws(state, draw); })
      ->UseManualTime()
      ->Iterations(5)
      ->Repetitions(5);
}

const bool kRegistered = [] {
  measureSmallDraws("arrays", drawArrays);
  measureSmallDraws("primitive", drawPrimitive);
  measureSmallDraws("list", callList);
  return true;
}();

}  // namespace

BENCHMARK_MAIN();
