// The lights that settings add to those of programs, as paths draw them. Made once a frame, asked on all
// tracing threads.
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
  /// `glass`: some surfaces let light through by paths that bend.
  AddedLights(const FrameData&, bool glass);
  bool empty() const { return shapes_.empty(); }
  size_t size() const { return shapes_.size(); }
  const LightShape& operator[](size_t i) const { return shapes_[i]; }
  /// Whether paths that go on in a direction by chance meet the light, so that sample() gives only a part of
  /// its light. Where there is glass, those that cannot be seen shine straight through it instead.
  bool isMet(size_t i) const { return !glass_ || shapes_[i].isVisible(); }

 private:
  std::vector<LightShape> shapes_;
  bool glass_ = false;
};

}  // namespace gluray::render
