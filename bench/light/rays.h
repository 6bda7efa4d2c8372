// Occlusion and shadow rays of a bare Embree loop, to compare the integrators' with.
#pragma once
#include "bench/data/orbit.h"
#include "bench/data/triangle_mesh.h"

#include <array>

namespace gluray::bench {

struct BareRays {
  double seconds = 0;  // of the fastest round
  size_t rays = 0;
};

/// Where a bare loop's rays go, one from each point that the camera sees, with one of 16 samples for each
/// pixel of a 4x4 packet.
struct BareAim {
  double length = 0;              // of the rays; 0: without end
  bool towardsLight = false;      // false: over the hemisphere about the normal
  std::array<double, 3> light{};  // unit vector towards it; surfaces that face away have no rays
  double angle = 0;               // of the light, degrees
};

/// Shoots them in packets of 16, the incoherent flag, with `threads` threads (0: all).
BareRays shootBareRays(const TriangleMesh&, const CameraPose&, const BareAim&, int threads, int rounds);

}  // namespace gluray::bench
