// Shading of shadow catchers: only the light that other surfaces remove. Tracing threads.
#pragma once
#include "render/integrators/integrator.h"
#include "render/integrators/light_visibility.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace gluray::render {

/// Replaces colours by black with opacity 1 - L / L0, where L and L0 are the luminances of `rows` (with all
/// other surfaces) and `open` (without them). The opacity is 0 if L0 is 0.
void showTaken(const ColorRows& open, ColorRows& rows);

/// Applies another integrator, and shows hits on the catcher by their missing light.
class CatcherLook final : public Integrator {
 public:
  /// `light` must not be null; `catcher`: the instance.
  CatcherLook(std::unique_ptr<const Integrator> light, uint32_t catcher)
      : light_(std::move(light)), catcher_(catcher) {}
  void light(const ColoredHits&, ColorRows&) const noexcept override;

 private:
  std::unique_ptr<const Integrator> light_;
  uint32_t catcher_;
};

/// Treats all surfaces as catchers (scene::Snapshot::catches), with the visibility of `light`.
class AllCaught final : public VisibilityIntegrator {
 public:
  explicit AllCaught(std::unique_ptr<const VisibilityIntegrator> light) : light_(std::move(light)) {}
  UsedVisibility used() const noexcept override { return light_->used(); }
  void estimate(const AskedPoints& points, Visibility& visibility) const noexcept override {
    light_->estimate(points, visibility);
  }
  void locate(const ColoredHits& hits, AskedPoints& points) const noexcept override {
    light_->locate(hits, points);
  }
  bool replaces(uint32_t, uint32_t, const Visibility&) const noexcept override { return false; }
  void apply(const ColoredHits&, const Visibility&, ColorRows&) const noexcept override;
  std::vector<float> meaning() const override { return light_->meaning(); }
  std::vector<glm::vec3> lightPlaces() const override { return light_->lightPlaces(); }
  std::optional<float> occlusionAlone() const noexcept override { return light_->occlusionAlone(); }

 private:
  std::unique_ptr<const VisibilityIntegrator> light_;
};

/// FrameData::caughtOcclusion of a moving frame with this integrator: none if any of the surfaces has a look
/// that differs from point to point, as with lights of its own.
std::optional<float> caughtOcclusionOf(const FrameData&, const VisibilityIntegrator&);

/// Treats all surfaces as catchers without missing light.
class NothingCaught final : public Integrator {
 public:
  void light(const ColoredHits&, ColorRows& rows) const noexcept override {
    const ColorRows open = rows;
    showTaken(open, rows);
  }
};

}  // namespace gluray::render
