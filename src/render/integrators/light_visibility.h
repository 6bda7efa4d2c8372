// Light transport as visibility, the share of light that arrives: traced first, perhaps filtered, then
// multiplied into the local look. Tracing threads.
#pragma once
#include "render/integrators/integrator.h"
#include "render/integrators/surface_points.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace gluray::render {

/// Maximum number of lights with shadows in a frame; the weakest lights beyond it cast none.
constexpr int kShadowLights = 4;

/// Visibility at the hits of a packet. Lanes outside the group are undefined, as are rows that the integrator
/// does not use (VisibilityIntegrator::used).
struct Visibility {
  alignas(64) Row occlusion;  // unoccluded fraction of ambient light: 0 .. 1
  // Visibility of shadow light r: 0 .. 1, red, green and blue. The three rows are equal unless translucent
  // surfaces tint shadows.
  alignas(64) Row lights[kShadowLights][3];
};

/// Which parts of the visibility an integrator uses; the same for all of a frame's hits.
struct UsedVisibility {
  bool occlusion = false;
  int lights = 0;        // rows of Visibility::lights
  bool colored = false;  // their channels may differ
  bool operator==(const UsedVisibility&) const = default;
};

/// An integrator whose noise is confined to visibility, so that a filter does not blur colours.
class VisibilityIntegrator : public Integrator {
 public:
  virtual UsedVisibility used() const noexcept = 0;
  /// Traces rays for the points in `lanes`.
  virtual void estimate(const AskedPoints&, Visibility&) const noexcept = 0;
  /// The points of hits, for estimate().
  virtual void locate(const ColoredHits&, AskedPoints&) const noexcept = 0;
  /// Whether apply() would compute the colours anew from the surface, so that they need not be there before.
  virtual bool replaces(uint32_t instance, uint32_t lanes, const Visibility&) const noexcept = 0;
  /// Applies visibility to colours of the local look.
  virtual void apply(const ColoredHits&, const Visibility&, ColorRows&) const noexcept = 0;
  /// The strength of occlusion, if apply() only multiplies the colours of each surface whose look is
  /// constant by 1 - strength * (1 - Visibility::occlusion).
  virtual std::optional<float> occlusionAlone() const noexcept { return {}; }
  /// What tells volumes apart. Earlier visibility is reusable while these numbers stay equal, up to rounding.
  virtual std::vector<float> meaning() const { return {}; }
  /// The places of the shadow lights, world space: directions of unit length, and positions as shares of the
  /// scene's diagonal. Earlier occlusion does not depend on them; earlier shadows do.
  virtual std::vector<glm::vec3> lightPlaces() const { return {}; }
  void light(const ColoredHits& hits, ColorRows& rows) const noexcept final {
    if (hits.visibility) return apply(hits, *hits.visibility, rows);
    AskedPoints points;
    locate(hits, points);
    Visibility visibility;
    estimate(points, visibility);
    apply(hits, visibility, rows);
  }
  void lightAlone(const ColoredHits& hits, ColorRows& rows) const noexcept final {
    Visibility all;
    std::fill_n(all.occlusion, kLanes, 1.0f);
    std::fill_n(&all.lights[0][0][0], kShadowLights * 3 * kLanes, 1.0f);
    apply(hits, all, rows);
  }
};

}  // namespace gluray::render
