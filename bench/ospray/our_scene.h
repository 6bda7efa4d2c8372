// The frame benchmark's mesh in GLuRay's renderer, lit as in OsprayScene. One thread uses it.
#pragma once
#include "bench/data/orbit.h"
#include "bench/data/triangle_mesh.h"
#include "frame/tracing/renderer.h"

#include <cstdint>
#include <string>
#include <vector>

namespace gluray::bench {

class OurScene {
 public:
  /// `settings`: NAME=VALUE. `mesh` must outlive it. Throws std::runtime_error.
  OurScene(const TriangleMesh& mesh, int threads, const std::vector<std::string>& settings);
  /// A frame of an animation, as programs get it while the camera moves.
  void frame(const CameraPose& pose, Image& image);
  /// One pass of an image at rest. `accumulate`: added to those since the last call without it.
  void pass(const CameraPose& pose, bool accumulate);
  /// The mean of the passes: RGBA8, bottom row first.
  std::vector<uint32_t> pixels() const;
  /// Not 0 where the last pass hit a surface.
  std::vector<uint8_t> hits() const;

 private:
  void render(const CameraPose& pose, Image& image);

  scene::Snapshot snapshot_;
  frame::Renderer renderer_;
  Image image_;  // of the last pass
  std::vector<double> sum_;
  uint32_t passes_ = 0;
};

}  // namespace gluray::bench
