// The scene of the light benchmark: a mesh or lines, a world, a camera on an orbit of one degree a frame.
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
  int lines = 0;  // so many field lines of a star as tubes of two pixels, in place of triangles
  int threads = 0;
  int width = 0, height = 0;  // pixels; 0: kImageSize
};

/// How a frame is traced.
struct Way {
  scene::LightSampling::Mode mode = scene::LightSampling::Mode::full;
  render::MovingRays rays;
  uint64_t view = 0;
  bool fresh = false;             // without history
  std::vector<std::string> more;  // settings beside the stage's
  uint32_t pass = 0;              // of full frames
  bool wide = false;              // colours as floats
  bool allThreads = false;        // of the machine
};

/// Seconds of a frame: by the clock, and of processor time of all threads.
struct FrameTime {
  double wall = 0, cpu = 0;
};

class Stage {
 public:
  /// Throws std::runtime_error where Embree fails.
  explicit Stage(const StageOptions&);
  /// Sets NAME=VALUE each; forgets earlier frames. Throws std::runtime_error where a setting is unknown.
  void use(const std::vector<std::string>& settings);
  /// What frame `degree` took, without building structures.
  FrameTime trace(int degree, const Way&, Image&);
  /// What frame `degree` shows, with settings beside the stage's.
  scene::Snapshot at(int degree, const std::vector<std::string>& more) const;
  /// Seconds that an image took that does not move.
  double trace(const scene::Snapshot&, Image&);
  const TriangleMesh& mesh() const { return mesh_; }
  const Settings& settings() const { return snapshot_.settings; }
  size_t primitives() const { return snapshot_.instances[0].mesh->triangleCount; }
  size_t historyBytes() const { return histories_.bytes(); }
  /// Of the image.
  double pixels() const { return double(snapshot_.region.width) * snapshot_.region.height; }

 private:
  TriangleMesh mesh_;
  Arena arena_, all_{0};
  scene::Snapshot snapshot_;
  accel::World world_;
  render::LightHistories histories_;
  int threads_;
};

/// Which pixels show something.
std::vector<uint8_t> hitsOf(const Image&);

}  // namespace gluray::bench
