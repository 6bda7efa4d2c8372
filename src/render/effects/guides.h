// What a filter of finished pictures, or somebody who picks a pixel, must know of it in place of its colour.
// Made for passes of the modes reflectance, geometry and surfaces (scene/light_sampling.h); called on all
// tracing threads.
#pragma once
#include "render/integrators/altered_look.h"
#include "render/integrators/integrator.h"
#include "render/integrators/metric.h"
#include "render/moving/film_space.h"

namespace gluray::render {

/// Red, green and blue become the surface's reflectance, as paths know it.
class ReflectanceGuide final : public Integrator {
 public:
  explicit ReflectanceGuide(const FrameData& frame) : frame(frame), colors(surfaceColors(frame, true)) {}
  void light(const ColoredHits&, ColorRows&) const noexcept override;

  const FrameData& frame;
  SurfaceColors colors;
};

/// The four channels become the plane of the surface, in units of the width of a pixel there: (a, b, c, d).
/// A pixel x columns and y rows away, whose own fourth channel is e, lies
///   a x + b y + c (1 - d / e)
/// away from it. a and b are the normal's components along rows and columns; c <= 0.
class GeometryGuide final : public Integrator {
 public:
  /// Throws std::runtime_error where rays of the viewer are not linear in the pixel's position.
  explicit GeometryGuide(const FrameData&);
  void light(const ColoredHits&, ColorRows&) const noexcept override;

  /// Parallel projections are treated as perspectives from so many widths of a pixel away.
  static constexpr float kFarAway = 131072;

  const FrameData& frame;
  Metric metric;
  FilmSpace space;
};

/// Red, green and blue become the normal (mode surfaces: of unit length, on the viewer's side) or the point,
/// in eye space; alpha the number of the instance, counted from 1. Exact for the first 2^24 instances.
class SurfaceGuide final : public Integrator {
 public:
  explicit SurfaceGuide(const FrameData& of) : frame(of), metric(of) {}
  void light(const ColoredHits&, ColorRows&) const noexcept override;

  const FrameData& frame;
  Metric metric;
};

/// The guide that the snapshot's mode asks for; null where colours of the local look are the answer.
std::unique_ptr<const Integrator> makeGuide(const FrameData&);
/// Whether the snapshot asks for guides in place of colours.
bool wantsGuide(const scene::Snapshot&);

}  // namespace gluray::render
