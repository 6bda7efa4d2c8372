// Occlusion rays of a bare Embree loop, to compare the integrators' with.
#pragma once
#include "bench/data/orbit.h"
#include "bench/data/triangle_mesh.h"

namespace gluray::bench {

struct BareRays {
  double seconds = 0;  // of the fastest round
  size_t rays = 0;
};

/// Shoots one ray from each point that the camera sees, with one of 16 directions about the normal for each
/// pixel of a 4x4 packet, as long as `radius`; packets of 16, the incoherent flag, `threads` threads (0:
/// all).
BareRays shootBareRays(const TriangleMesh&, const CameraPose&, double radius, int threads, int rounds);

}  // namespace gluray::bench
