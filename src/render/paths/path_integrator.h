// Path tracing: light that bounces between surfaces before it reaches the viewer.
#pragma once
#include "render/integrators/integrator.h"
#include "render/paths/path.h"

namespace gluray::render {

/// The light that leaves a point towards the viewer (J. Kajiya, "The Rendering Equation", 1986):
///   L(p, wo) = Le(p, wo) + integral of f(p, wo, wi) L(p', wi) |cos(wi)| dwi,  p' where the ray p + t wi
///   ends.
/// Each sample follows one path from the viewer. At each vertex, the program's lights and the environment are
/// sampled directly, and the next direction is sampled from the material (E. Veach, "Robust Monte Carlo
/// Methods for Light Transport Simulation", 1997). The integrator replaces the colours of the local look;
/// alpha and depth stay.
class PathIntegrator final : public Integrator {
 public:
  /// `frame` must outlive it. Throws std::runtime_error where the modelview matrix cannot be inverted.
  explicit PathIntegrator(const FrameData& frame) : path_(frame) {}
  void light(const ColoredHits&, ColorRows&) const noexcept override;
  void lightAlone(const ColoredHits&, ColorRows&) const noexcept override;

 private:
  Path path_;
};

/// The part of that light which is equal in all samples: what surfaces emit, and what comes straight from
/// lights without size. Black where the image is encoded, so that light does not add up.
class NoiselessLight final : public Integrator {
 public:
  /// As PathIntegrator.
  explicit NoiselessLight(const FrameData& frame) : path_(frame) {}
  void light(const ColoredHits&, ColorRows&) const noexcept override;

 private:
  Path path_;
};

}  // namespace gluray::render
