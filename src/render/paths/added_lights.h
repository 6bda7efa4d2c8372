// Samples the lights that settings add to those of programs, for path tracing. Made once a frame, called on
// all tracing threads.
#pragma once
#include "render/frame_data/frame_data.h"
#include "render/lights/light_shape.h"

#include <memory>
#include <vector>

namespace gluray::render {

class Environment;

/// The lights of rigs and files; they shine on all surfaces.
class AddedLights {
 public:
  AddedLights() = default;
  /// `glass`: some surfaces refract light.
  AddedLights(const FrameData&, bool glass);
  bool empty() const { return shapes_.empty(); }
  size_t size() const { return shapes_.size(); }
  const LightShape& operator[](size_t i) const { return shapes_[i]; }
  /// Whether paths sampled from materials can hit the light, so that sample() is weighted against them. In
  /// scenes with glass, invisible lights shine straight through glass instead.
  bool isMet(size_t i) const { return !glass_ || shapes_[i].isVisible(); }

 private:
  std::vector<LightShape> shapes_;
  bool glass_ = false;
};

}  // namespace gluray::render
