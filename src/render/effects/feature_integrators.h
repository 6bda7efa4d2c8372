// Integrators that replace colours by auxiliary features: reflectance, geometry or points, for the filter of
// finished images and for picking. Made for passes of the modes reflectance, geometry and surfaces
// (scene/light_sampling.h); called on all tracing threads.
#pragma once
#include "render/integrators/altered_look.h"
#include "render/integrators/integrator.h"
#include "render/integrators/metric.h"
#include "render/moving/pixel_space.h"

namespace gluray::render {

/// Replaces red, green and blue by the surface's reflectance in path tracing.
class ReflectanceFeature final : public Integrator {
 public:
  explicit ReflectanceFeature(const FrameData& frame) : frame(frame), colors(surfaceColors(frame, true)) {}
  void light(const ColoredHits&, ColorRows&) const noexcept override;

  const FrameData& frame;
  SurfaceColors colors;
};

/// Replaces the four channels by the plane of the surface, in units of the pixel width at the surface: (a, b,
/// c, d). A pixel x columns and y rows away, whose own fourth channel is e, lies
///   a x + b y + c (1 - d / e)
/// away from it. a and b are the normal's components along rows and columns; c <= 0. Of layers, whose alpha
/// stays: (a, b, d, alpha).
class GeometryFeatures final : public Integrator {
 public:
  /// Throws std::runtime_error where rays of the viewer are not linear in the pixel's position.
  explicit GeometryFeatures(const FrameData&);
  void light(const ColoredHits&, ColorRows&) const noexcept override;
  /// c of a surface with this a and b, seen at (x, y) in pixels from the centre of the region's first pixel.
  float facing(float a, float b, float x, float y) const noexcept;

  /// Parallel projections count as perspectives from this distance, in pixel widths.
  static constexpr float kFarAway = 131072;

  const FrameData& frame;
  Metric metric;
  PixelSpace space;
  bool perspective;
  float width;          // of a pixel: at depth 1 in perspectives
  glm::vec3 right, up;  // along rows and columns of pixels, eye space
};

/// Replaces red, green and blue by the normal (unit length, on the viewer's side) or the point, in eye space,
/// and alpha by the number of the instance, counted from 1. Exact for the first 2^24 instances.
class SurfaceFeatures final : public Integrator {
 public:
  explicit SurfaceFeatures(const FrameData& of) : frame(of), metric(of) {}
  void light(const ColoredHits&, ColorRows&) const noexcept override;

  const FrameData& frame;
  Metric metric;
};

/// Makes the guide of the snapshot's mode; null if the mode uses colours.
std::unique_ptr<const Integrator> makeFeatureIntegrator(const FrameData&);
/// Whether the snapshot's mode uses auxiliary features instead of colours.
bool wantsFeatures(const scene::Snapshot&);

}  // namespace gluray::render
