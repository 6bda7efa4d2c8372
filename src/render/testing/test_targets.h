// Runs tests with each instruction set of the processor in turn.
#pragma once
#include <hwy/targets.h>

#include <cstdint>

namespace gluray::test {

/// Restricts the vectorised code to these instruction sets (Highway's bits; 0: all); the destructor lifts the
/// restriction.
class Targets {
 public:
  Targets() = default;
  Targets(const Targets&) = delete;
  Targets& operator=(const Targets&) = delete;
  ~Targets() { use(0); }
  void use(int64_t targets) {
    hwy::SetSupportedTargetsForTest(targets);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
};

/// Calls `body(target)` for each instruction set that the processor supports and the code is compiled for,
/// best first. With HWY_COMPILE_ONLY_STATIC, as under sanitizers, there is only one.
template <class Body>
void withEachTarget(const Body& body) {
  Targets targets;
  for (int64_t rest = hwy::SupportedTargets() & HWY_TARGETS; rest; rest &= rest - 1) {
    const int64_t target = rest & -rest;
    targets.use(target);
    body(target);
  }
}

}  // namespace gluray::test
