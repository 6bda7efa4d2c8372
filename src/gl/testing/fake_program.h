// A program with its own clock, for tests of EngineChoice.
#pragma once
#include "gl/trials/engine_choice.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>

namespace gluray::gl::test {

using Way = EngineChoice::Way;

inline double g_now = 0;
inline int g_clockCalls = 0;
inline double fakeClock() { return ++g_clockCalls, g_now; }

/// A fake program whose frames take the time that the test sets.
struct FakeProgram {
  EngineChoice choice;
  double triangles = 2000, pixels = 300 * 300;
  std::function<double()> traced = [] { return 0.010; }, direct = [] { return 0.001; };
  double idle = 0;  // between frames
  int finishes = 0, traceFrames = 0, directFrames = 0, changes = 0;

  explicit FakeProgram(Engine engine = Engine::automatic, bool software = true,
                       std::shared_ptr<Precedents> precedents = nullptr)
      : choice({engine, 2, software, std::move(precedents)}, fakeClock) {
    g_now = 0, g_clockCalls = 0;
  }
  void frame() {
    const Way way = choice.way();
    if (choice.wantsStart()) ++finishes, choice.start();
    choice.drew(static_cast<uint64_t>(triangles), pixels);
    g_now += way == Way::traced ? traced() : direct();
    ++(way == Way::traced ? traceFrames : directFrames);
    if (choice.wantsStop()) ++finishes, choice.stop();
    g_now += idle;
    if (choice.frameEnded() != way) ++changes;
  }
  void frames(int n) {
    for (int i = 0; i < n; ++i) frame();
  }
};

}  // namespace gluray::gl::test
