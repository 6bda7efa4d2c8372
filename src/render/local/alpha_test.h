// The alpha test (GL 2.1, 4.1.4). Any thread.
#pragma once
#include "scene/shading.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {

/// Whether a fragment of that alpha passes the test.
inline bool passes(const scene::AlphaTest& test, float alpha) {
  const auto compared = [&](float a) {
    return test.asBytes ? std::nearbyint(std::clamp(a, 0.0f, 1.0f) * 255) : a;
  };
  const float a = compared(alpha), reference = compared(test.reference);
  switch (test.function) {
    case scene::AlphaTest::never: return false;
    case scene::AlphaTest::less: return a < reference;
    case scene::AlphaTest::lessOrEqual: return a <= reference;
    case scene::AlphaTest::equal: return a == reference;
    case scene::AlphaTest::greaterOrEqual: return a >= reference;
    case scene::AlphaTest::greater: return a > reference;
    case scene::AlphaTest::notEqual: return a != reference;
    default: return true;
  }
}

}  // namespace gluray::render
