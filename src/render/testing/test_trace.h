// Traces a snapshot for the tests of render/.
#pragma once
#include "accel/testing/test_scene.h"
#include "accel/world.h"
#include "render/tile_tracer.h"

namespace gluray::test {

/// A traced image with accessors by pixel and sample.
struct Traced {
  Image image;
  size_t at(int x, int y, int sample) const {
    return static_cast<size_t>((sample * image.height + y) * image.width + x);
  }
  float depth(int x, int y, int sample = 0) const { return image.depth[at(x, y, sample)]; }
  bool hit(int x, int y, int sample = 0) const { return depth(x, y, sample) != Image::kMiss; }
  /// RGBA, 0 .. 255.
  glm::vec4 color(int x, int y, int sample = 0) const {
    const uint32_t c = image.color[at(x, y, sample)];
    return {c & 255, c >> 8 & 255, c >> 16 & 255, c >> 24};
  }
};

inline Traced trace(const scene::Snapshot& snapshot) {
  Arena arena(snapshot.settings.threads);
  accel::World world;
  world.update(snapshot, arena);
  Traced traced;
  render::traceImage(snapshot, world, arena, traced.image);
  return traced;
}

/// Largest difference of two colours in any channel.
inline float difference(const glm::vec4& a, const glm::vec4& b) {
  const glm::vec4 d = glm::abs(a - b);
  return std::max(std::max(d.x, d.y), std::max(d.z, d.w));
}

}  // namespace gluray::test
