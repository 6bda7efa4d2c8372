// Light beyond OpenGL's local look. A frame's integrator changes the colours of hits that the local look has
// shaded. Frames without an integrator have no extra cost. Called on all tracing threads.
#pragma once
#include "render/frame_data/frame_data.h"
#include "render/local/group.h"

namespace gluray::render {

struct Visibility;
struct WaitingPoints;

/// Hits on one instance, coloured by the local look.
struct ColoredHits {
  const Surface& surface;
  uint32_t instance;
  const Group& group;                      // u and v: position of the visible point
  uint32_t back;                           // bit i: lane i shows its back face
  int sample;                              // index of the pixel's sample
  const float *x, *y;                      // window positions of the lanes
  const ColorRows* direct = nullptr;       // the hits without ambient light, if FrameData::direct is set
  const Visibility* visibility = nullptr;  // if already known
  WaitingPoints* waiting = nullptr;        // queue of points, if visibility is collected
  // Largest share of a pixel's colour that any of the hits has: translucent layers share light samples.
  float share = 1;
};

class Integrator {
 public:
  virtual ~Integrator() = default;
  /// Changes the colours of the group's lanes; other lanes are undefined.
  virtual void light(const ColoredHits&, ColorRows&) const noexcept = 0;
  /// The same as if the surface were alone in the scene.
  virtual void lightAlone(const ColoredHits& hits, ColorRows& rows) const noexcept { light(hits, rows); }
};

}  // namespace gluray::render
