// The frame benchmark's mesh in OSPRay: one renderer, one light and an ambient one. One thread uses it.
#pragma once
#include "bench/data/orbit.h"
#include "bench/data/triangle_mesh.h"

#include <ospray/ospray.h>

#include <cstdint>
#include <string>
#include <vector>

namespace gluray::bench {

class OsprayScene {
 public:
  struct Options {
    std::string renderer = "scivis";  // or "pathtracer", "ao"
    int threads = 0;                  // 0: one a core
    int occlusionSamples = 4;         // of scivis
    float occlusionDistance = 1e20f;  // world units
    bool shadows = true;              // of scivis
  };
  /// Builds on construction; `mesh` must outlive it. Throws std::runtime_error with OSPRay's own words.
  OsprayScene(const TriangleMesh& mesh, const Options& options);
  ~OsprayScene();
  OsprayScene(const OsprayScene&) = delete;
  OsprayScene& operator=(const OsprayScene&) = delete;

  /// Direction in which the light shines, world space.
  void shine(const std::array<double, 3>& direction);
  /// One frame of a sample a pixel. `accumulate`: added to the frames since the last call without it.
  void render(const CameraPose& pose, bool accumulate);
  /// The image: RGBA8, bottom row first, kImageSize * kImageSize.
  std::vector<uint32_t> pixels() const;

 private:
  void makeMesh(const TriangleMesh& mesh, const Options& options);
  void makeLights();
  OSPCamera camera_;
  OSPRenderer renderer_;
  OSPWorld world_;
  OSPFrameBuffer film_;
  OSPLight light_;
};

}  // namespace gluray::bench
