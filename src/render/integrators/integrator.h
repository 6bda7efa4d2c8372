// Light beyond OpenGL's local look: what lies between a point and its surroundings. An integrator is made for
// a frame, gets hits that the local look has coloured, and changes their colours. Frames without one cost and
// change nothing. Called on all tracing threads.
#pragma once
#include "render/frame_data/frame_data.h"
#include "render/local/group.h"

namespace gluray::render {

struct Factors;
struct WaitingPoints;

/// Hits on one instance, coloured by the local look.
struct ColoredHits {
  const Surface& surface;
  uint32_t instance;
  const Group& group;                 // its lanes count; u and v are where the surface is seen
  uint32_t back;                      // bit i: lane i shows its back face
  int sample;                         // of those that the pixel takes
  const float *x, *y;                 // window positions of the lanes
  const ColorRows* direct = nullptr;  // the same hits without ambient light, if FrameData::direct is there
  const Factors* factors = nullptr;   // where these are known already
  WaitingPoints* waiting = nullptr;   // where points wait for rays, if factors are collected
};

class Integrator {
 public:
  virtual ~Integrator() = default;
  /// Changes colours of the group's lanes; those of others have no meaning.
  virtual void light(const ColoredHits&, ColorRows&) const noexcept = 0;
  /// The same as if the surface were alone in the scene.
  virtual void lightAlone(const ColoredHits& hits, ColorRows& rows) const noexcept { light(hits, rows); }
};

}  // namespace gluray::render
