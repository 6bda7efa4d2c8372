// Ambient occlusion and shadows of the local look.
#pragma once
#include "render/effects/ambient_occlusion.h"
#include "render/effects/shadows.h"

#include <optional>

namespace gluray::render {

/// The local look with shadows, ambient occlusion, or both.
class SurfaceLight final : public VisibilityIntegrator {
 public:
  /// `frame` must outlive it. Throws std::runtime_error where the modelview matrix cannot be inverted.
  /// `occludes`: false: without ambient occlusion, whatever the settings say.
  explicit SurfaceLight(const FrameData& frame, bool occludes = true);
  /// Whether it changes anything.
  bool acts() const { return occlusion_ || shadows_ || dome_ || hasAreas_; }

  /// Whether all light is known without samples: there are shadows, all of them hard, and nothing else.
  bool castsHardShadowsAlone() const;

  UsedVisibility used() const noexcept override;
  void estimate(const AskedPoints&, Visibility&) const noexcept override;
  void locate(const ColoredHits&, AskedPoints&) const noexcept override;
  bool replaces(uint32_t instance, uint32_t lanes, const Visibility&) const noexcept override;
  void apply(const ColoredHits&, const Visibility&, ColorRows&) const noexcept override;
  std::vector<float> meaning() const override;
  std::vector<glm::vec3> lightPlaces() const override;
  std::optional<float> occlusionAlone() const noexcept override;

 private:
  bool isDomed(const ShadowLights::Rows& used) const { return dome_ && used.up != glm::vec3(0); }
  /// Shades hits again if they have shadows, a dome or area lights. Returns whether it did.
  bool relight(const ColoredHits&, const Visibility&, ColorRows&) const;
  void shadeArriving(const Surface&, const ColoredHits&, const Visibility&, const scene::Dome*,
                     ColorRows&) const;
  /// `kept`: the part of the colours that stays as it is; null: none. `reflectance`: the surfaces' colours
  /// under their own light; null: occluded points get no reflected light.
  void occlude(const Visibility&, const ColorRows* kept, const ColorRows* reflectance, ColorRows&) const;

  const FrameData& frame_;
  Metric metric_;
  Occluders occluders_;
  ShadowLights lights_;
  const scene::Dome* dome_ = nullptr;  // null: there is none
  bool hasAreas_ = false;              // some light is an area
  std::optional<AmbientOcclusion> occlusion_;
  std::optional<Shadows> shadows_;
};

}  // namespace gluray::render
