// The scene of a frame as paths of light see it (path_integrator.h).
#pragma once
#include "render/bsdf/material_model.h"
#include "render/integrators/altered_look.h"
#include "render/integrators/metric.h"
#include "render/integrators/occluders.h"
#include "render/lights/environment.h"
#include "render/paths/added_lights.h"
#include "render/paths/pictured_colors.h"
#include "render/paths/shading_lights.h"

#include <memory>
#include <vector>

namespace gluray::render {

struct PathVertex;

/// What all paths of a frame need. Made once a frame, read by every tracing thread.
struct Path {
  /// `frame` must outlive it. Throws std::runtime_error where the modelview matrix cannot be inverted.
  explicit Path(const FrameData& frame);
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
  ShadingLights lights;
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
