// Transmittance of shadow rays in path tracing, including glass. Any thread.
#pragma once
#include "render/bsdf/material_model.h"
#include "render/integrators/occluders.h"

#include <algorithm>
#include <vector>

namespace gluray::render {

/// Light of lights without a size passes straight through glass, because no refracted path could hit such a
/// light.
class ClearShadows final : public accel::OccluderFilter {
 public:
  ClearShadows(const Occluders& occluders, const std::vector<MaterialModel>& materials)
      : occluders_(occluders), materials_(materials) {
    for (float& t : through) t = 1;
  }
  bool blocks(const accel::Occluder& occluder) const noexcept override {
    constexpr float kNothing = 0.5f / 255;  // lower values are invisible
    if (!occluders_.isThere(occluder)) return false;
    const MaterialModel& material = materials_[occluder.instance];
    float& left = through[occluder.lane];
    left *= material.isTransparent() ? 1 - bsdf::reflectanceAtNormal(material.ior)
                                     : 1 - occluders_.opacityOf(occluder);
    return left < kNothing;
  }
  bool usesPoints() const noexcept override { return occluders_.usePoints(); }

  mutable float through[accel::kLanes];  // of rays that are not blocked

 private:
  const Occluders& occluders_;
  const std::vector<MaterialModel>& materials_;
};

}  // namespace gluray::render
