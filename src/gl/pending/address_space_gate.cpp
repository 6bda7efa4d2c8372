#include "gl/pending/address_space_gate.h"

#include "base/processes/address_space.h"

#include <atomic>

namespace gluray::gl {

bool addressSpaceIsShort() noexcept {
  constexpr int kCalls = 32;
  static std::atomic<int> skipped{kCalls};  // calls since no limit was found
  if (const int calls = skipped.load(std::memory_order_relaxed); calls < kCalls) {
    skipped.store(calls + 1, std::memory_order_relaxed);
    return false;
  }
  const unsigned long long left = glurayAddressSpaceLeft();
  if (left == ULLONG_MAX) skipped.store(1, std::memory_order_relaxed);
  return left < glurayFrameReserve;
}

}  // namespace gluray::gl
