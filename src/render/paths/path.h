// Path tracing: light that bounces between surfaces before it reaches the viewer.
#pragma once
#include "render/bsdf/material_model.h"
#include "render/integrators/altered_look.h"
#include "render/integrators/integrator.h"
#include "render/integrators/metric.h"
#include "render/integrators/occluders.h"
#include "render/lights/added_lights.h"
#include "render/lights/environment.h"
#include "render/lights/program_lights.h"
#include "render/paths/pictured_colors.h"

#include <memory>
#include <vector>

namespace gluray::render {

struct PathVertex;

/// The light that leaves a point towards the viewer (J. Kajiya, "The Rendering Equation", 1986):
///   L(p, wo) = Le(p, wo) + integral of f(p, wo, wi) L(p', wi) |cos(wi)| dwi,  p' where the ray p + t wi
///   ends.
/// Each sample follows one path from the viewer. At each of its vertices the program's lights and the
/// environment are asked directly, and the next direction is drawn from the material (E. Veach, "Robust Monte
/// Carlo Methods for Light Transport Simulation", 1997). It replaces the colours of the local look; alpha and
/// depth stay.
class Path final : public Integrator {
 public:
  /// `frame` must outlive it. Throws std::runtime_error where the modelview matrix cannot be inverted.
  explicit Path(const FrameData& frame);
  void light(const ColoredHits&, ColorRows&) const noexcept override;
  void lightAlone(const ColoredHits&, ColorRows&) const noexcept override;
  /// Index of the first of the samples that sample `sample` of a pixel takes in this pass.
  uint32_t firstSample(int sample) const;
  /// Colours where paths meet surfaces that the camera does not look at.
  const SurfaceColors& bounced() const { return unseen.albedo ? unseen : seen; }
  /// `inside`: the path comes from within the surface's body.
  bsdf::Any bsdfOf(const PathVertex&, bool inside) const;
  /// A light of colour 1 has this irradiance: pi, so that a white diffuse surface that faces it shows 1;
  /// VTK's physically based shading has 1.
  float irradianceOfOne(const PathVertex&) const;

  const FrameData& frame;
  Metric metric;
  Occluders occluders;
  ProgramLights lights;
  AddedLights added;
  std::vector<MaterialModel> materials;            // as FrameData::surfaces
  SurfaceColors seen, unseen;                      // of hits of the camera, of others where they differ
  std::shared_ptr<const PicturedColors> pictured;  // null: no surface is pictured
  std::shared_ptr<const Environment> environment;
  float lightScale;    // of the lights
  int samples;         // paths a pixel's sample
  int depth;           // vertices of a path
  float mostIndirect;  // firefly clamp: largest component of what one path brings from bounces; 0: any
  bool bounces;        // false: only mirrors and glass send paths on (T. Whitted, 1980)
  bool hasGlass = false;
  bool filters;   // some texture needs to know how wide pixels are
  bool mirrored;  // the projection mirrors the window
};

}  // namespace gluray::render
