// The bare loop's scene: one mesh in one Embree scene, and the rays of one image.
#pragma once
#include "bench/bare/embree.h"
#include "bench/data/orbit.h"
#include "bench/data/triangle_mesh.h"

#include <cstdint>
#include <string>
#include <vector>

namespace gluray::bench {

/// Builds on construction; throws std::runtime_error with Embree's own words where that fails.
class BareScene {
 public:
  /// `quality` is fast, full or compact: Embree's LOW, MEDIUM, and MEDIUM with the COMPACT flag.
  BareScene(const TriangleMesh& mesh, const std::string& quality, int threads);
  ~BareScene();
  BareScene(const BareScene&) = delete;
  BareScene& operator=(const BareScene&) = delete;

  /// Traces one ray a pixel and shades what it hits by the light at the camera, 0.2 + cos as the GL client's
  /// scene does. `rgba` is RGBA8, bottom row first, kImageSize * kImageSize * 4 bytes.
  void render(const CameraPose& pose, std::vector<uint8_t>& rgba) const;
  RTCScene scene() const { return scene_; }

 private:
  void renderTile(const CameraPose& pose, int tileX, int tileY, uint8_t* rgba) const;
  const TriangleMesh& mesh_;
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
};

}  // namespace gluray::bench
