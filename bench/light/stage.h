// The scene of the light benchmark: a mesh, a world, a camera on an orbit of one degree a frame.
#pragma once
#include "accel/world.h"
#include "base/image.h"
#include "bench/data/triangle_mesh.h"
#include "parallel/arena.h"
#include "render/tile_tracer.h"

#include <string>
#include <vector>

namespace gluray::bench {

struct StageOptions {
  double millionTriangles = 1;
  int threads = 0;
  std::vector<std::string> settings;  // NAME=VALUE
};

/// How a frame is traced.
struct Way {
  scene::LightSampling::Mode mode = scene::LightSampling::Mode::full;
  render::MovingRays rays;
  uint64_t view = 0;
  int samples = 0;     // ao.samples, and those of shadows; 0: as set
  bool light = true;   // false: the local look
  bool fresh = false;  // without history
};

class Stage {
 public:
  /// Throws std::runtime_error where a setting is unknown, or Embree fails.
  explicit Stage(const StageOptions&);
  /// Seconds that frame `degree` took, without building structures.
  double trace(int degree, const Way&, Image&);
  const TriangleMesh& mesh() const { return mesh_; }
  size_t historyBytes() const { return histories_.bytes(); }
  Arena& arena() { return arena_; }

 private:
  TriangleMesh mesh_;
  Arena arena_;
  scene::Snapshot snapshot_;
  accel::World world_;
  render::LightHistories histories_;
};

/// Peak signal to noise, dB, of the pixels that hit something.
double psnr(const Image& picture, const Image& reference);

}  // namespace gluray::bench
