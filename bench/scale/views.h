// The images of the scaling benchmarks: views of the Wavelet's isosurfaces on an orbit of one degree a
// frame. Any thread.
#pragma once
#include "bench/data/isosurface.h"
#include "bench/data/wavelet.h"
#include "bench/render/wavelet_snapshot.h"

#include <glm/glm.hpp>

namespace gluray::bench {

inline TriangleMesh waveletMesh(double millions) {
  const Volume volume = wavelet();
  const auto [low, high] = volume.range();
  return isosurfaces(volume, evenIsovalues(low, high, waveletSurfaces(millions)));
}

/// The view of that frame. `samples`: rays of ambient occlusion a pixel; 0: OpenGL's local look.
inline void show(scene::Snapshot& s, int frame, int samples, int threads) {
  lookFrom(s, orbitPose(frame, 360));
  s.instances[0].lightingFromObject = glm::mat4(s.instances[0].eyeFromObject);
  s.frame = static_cast<uint64_t>(frame);
  s.settings.bvh = BvhQuality::full;
  s.settings.threads = threads;
  s.settings.ao.enabled = samples > 0;
  if (samples > 0) s.settings.ao.samples = samples;
}

}  // namespace gluray::bench
