// Instruction sets in tests: each that the processor has, one after another.
#pragma once
#include <hwy/targets.h>

#include <cstdint>

namespace gluray::test {

/// Lets the vectorised code use but these instruction sets (Highway's bits; 0: whatever there is) and gives
/// all back in the end.
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

/// Calls `body(target)` with every instruction set in use that the processor has and the code is compiled
/// for, the best first. With HWY_COMPILE_ONLY_STATIC, as under sanitizers, there is one.
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
