// The scene of a frame for path tracing (path_integrator.h).
#pragma once
#include "render/bsdf/material_model.h"
#include "render/integrators/altered_look.h"
#include "render/integrators/metric.h"
#include "render/integrators/occluders.h"
#include "render/lights/environment.h"
#include "render/paths/added_lights.h"
#include "render/paths/captured_colors.h"
#include "render/paths/shading_lights.h"

#include <memory>
#include <vector>

namespace gluray::render {

struct PathVertex;

/// Data shared by all paths of a frame. Made once a frame, read by every tracing thread.
struct Path {
  /// `frame` must outlive it. Throws std::runtime_error where the modelview matrix cannot be inverted.
  explicit Path(const FrameData& frame);
  /// Colours of surfaces at vertices after the first.
  const SurfaceColors& bounced() const { return unseen.albedo ? unseen : seen; }
  /// `inside`: the path arrives from inside the body.
  bsdf::Any bsdfOf(const PathVertex&, bool inside) const;
  /// Irradiance of a light of colour 1: pi, so that a white diffuse surface facing the light has the value 1;
  /// for VTK's physically based shading 1.
  float irradianceOfOne(const PathVertex&) const;

  const FrameData& frame;
  Metric metric;
  Occluders occluders;
  ShadingLights lights;
  AddedLights added;
  std::vector<MaterialModel> materials;            // as FrameData::surfaces
  SurfaceColors seen, unseen;                      // at camera hits; at other hits if different
  std::shared_ptr<const CapturedColors> captured;  // null: no surface is captured
  std::shared_ptr<const Environment> environment;
  float lightScale;    // of the lights
  int samples;         // paths per pixel sample
  int depth;           // maximum vertices of a path
  float mostIndirect;  // firefly clamp: largest component of one path's indirect light; 0: no limit
  bool bounces;        // false: paths continue only at mirrors and glass (T. Whitted, 1980)
  bool hasGlass = false;
  bool filters;   // some texture needs the pixel footprint
  bool mirrored;  // the projection mirrors the window
};

}  // namespace gluray::render
