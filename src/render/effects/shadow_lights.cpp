#include "render/effects/shadow_lights.h"

#include "base/log.h"
#include "render/integrators/light_visibility.h"
#include "render/lights/light_conversion.h"
#include "render/lights/relit.h"
#include "render/local/lighting_space.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace gluray::render {
namespace {

using scene::LightSource;
using Kind = LightSource::Kind;

float brightness(const LightSource& l) {
  return l.strength * std::max(l.color.x, std::max(l.color.y, l.color.z));
}

/// Whether the viewer sees none of its shadows, because each is behind what casts it.
bool isAtViewer(const LightSource& light, const Metric& metric) {
  constexpr double kNear = 1e-4;
  const glm::dvec3 away(metric.away);
  const bool parallel = std::abs(metric.away.w) * metric.diagonal <= kNear * glm::length(away);
  if (light.kind == Kind::distant)
    return parallel && glm::length(glm::dvec3(light.direction) - glm::normalize(away)) < kNear;
  if (parallel || (light.kind != Kind::point && light.kind != Kind::spot)) return false;
  return glm::length(glm::dvec3(light.position) - away / metric.away.w) <= kNear * metric.diagonal;
}

/// Whether two draws have the same light, up to the rounding of matrices that programs multiply in float.
bool isSame(const LightSource& a, const LightSource& b, const Metric& metric) {
  const float near = 1e-4f;
  LightSource moved = b;
  moved.position = a.position, moved.direction = a.direction;
  return moved == a && glm::length(a.direction - b.direction) <= near &&
         glm::length(a.position - b.position) <= near * metric.diagonal;
}

/// Programs draw small unlit things around their lights, to show where they are.
bool isLamp(const scene::Instance& instance, const glm::vec3& light, const Metric& metric) {
  constexpr double kSmall = 0.1;  // of the scene
  const glm::dvec3 lower(instance.mesh->lower), upper(instance.mesh->upper),
      at(glm::inverse(instance.eyeFromObject) * glm::dvec4(light, 1));
  for (int c = 0; c < 3; ++c)
    if (!(at[c] >= lower[c] && at[c] <= upper[c])) return false;
  const glm::dvec3 size = glm::dmat3(instance.eyeFromObject) * (upper - lower);
  return glm::length(size) < kSmall * metric.diagonal;
}

class Finder {
 public:
  Finder(const FrameData& frame, const Metric& metric) : frame_(frame), metric_(metric) {}

  ShadowLights find(bool casts) {
    ShadowLights out;
    known_.resize(frame_.lightings.size());
    for (uint32_t i = 0; i < frame_.snapshot->instances.size(); ++i)
      out.rowsOfInstance.push_back(rowsOf(i, out));
    choose(casts, out);
    return out;
  }

 private:
  struct Known {
    glm::dmat4 eyeFromLighting;
    uint32_t rows;
  };

  uint32_t rowsOf(uint32_t i, ShadowLights& out) {
    const scene::Instance& instance = frame_.snapshot->instances[i];
    const scene::Shading& shading = frame_.shadings()[frame_.shadingOf(i)];
    const bool program = shading.fragment.model != scene::FragmentShading::Model::off;
    const glm::dmat4 space = eyeFromLighting(instance, shading, metric_.away);
    const double reach = glm::length(glm::dvec3(instance.eyeFromObject[3]));
    std::vector<Known>& known = known_[frame_.shadingOf(i)];
    for (const Known& k : known)
      if (isNearly(k.eyeFromLighting, space, reach)) return k.rows;
    known.push_back({space, static_cast<uint32_t>(out.rows.size())});
    out.rows.push_back(numbersOf(frame_.shadingOf(i), program, space));
    return known.back().rows;
  }

  /// Its lights as numbers of lights_.
  ShadowLights::Rows numbersOf(uint32_t index, bool program, const glm::dmat4& eyeFromLighting) {
    const scene::Shading& shading = frame_.shadings()[index];
    ShadowLights::Rows rows;
    rows.eyeFromLighting = glm::mat3(eyeFromLighting);
    const size_t count = program ? shading.fragment.lights.size() : frame_.lightings[index].lights.size();
    numbers_.emplace_back();
    for (size_t l = 0; l < count; ++l)
      numbers_.back().push_back(numberOf(index, l, program, eyeFromLighting));
    if (frame_.relit && frame_.relit->dome.shines() && isLit(shading)) {
      const glm::dmat3 lightingFromEye(glm::inverse(eyeFromLighting));
      rows.up = glm::vec3(glm::normalize(lightingFromEye * glm::dvec3(frame_.relit->dome.up)));
    }
    return rows;
  }

  std::optional<LightSource> sourceAt(uint32_t index, size_t l, bool program,
                                      const glm::dmat4& eyeFromLighting) const {
    const scene::Shading& shading = frame_.shadings()[index];
    if (frame_.relit && l >= frame_.relit->firstSource[index])
      return frame_.relit->sources[l - frame_.relit->firstSource[index]];
    if (!program) return sourceOf(shading.lights[l]);
    const scene::FragmentLight& light = shading.fragment.lights[l];
    if (light.kind == scene::FragmentLight::headlight) return {};
    return sourceOf(light, eyeFromLighting);
  }

  int numberOf(uint32_t index, size_t l, bool program, const glm::dmat4& eyeFromLighting) {
    const std::optional<LightSource> source = sourceAt(index, l, program, eyeFromLighting);
    if (!source || brightness(*source) <= 0 || isAtViewer(*source, metric_)) return -1;
    for (size_t i = 0; i < lights_.size(); ++i)
      if (isSame(*source, lights_[i], metric_)) return static_cast<int>(i);
    lights_.push_back(*source);
    return static_cast<int>(lights_.size()) - 1;
  }

  /// Gives rows to the strongest.
  void choose(bool casts, ShadowLights& out) {
    std::vector<int> order(lights_.size());
    for (size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
    const auto strength = [&](int i) { return brightness(lights_[static_cast<size_t>(i)]); };
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return strength(a) > strength(b); });
    const bool dome = frame_.relit && frame_.relit->dome.shines();
    const size_t most = casts ? kShadowLights - (dome ? 1 : 0) : 0;
    if (casts && order.size() > most)
      log::once(log::Level::warning, "shadow lights", "shadows: only the four strongest lights cast shadows");
    order.resize(std::min(order.size(), most));
    std::vector<int8_t> row(lights_.size(), -1);
    for (const int i : order) {
      row[static_cast<size_t>(i)] = static_cast<int8_t>(out.lights.size());
      out.lights.push_back(lights_[static_cast<size_t>(i)]);
    }
    for (const LightSource& light : out.lights) {
      const bool mayHave = light.kind == Kind::point || light.kind == Kind::spot;
      out.lamps.push_back(mayHave ? lampsOf(frame_, metric_, light.position) : std::vector<uint32_t>());
    }
    if (casts && dome)
      out.dome = static_cast<int>(out.lights.size()), out.lights.emplace_back(), out.lamps.emplace_back();
    for (size_t r = 0; r < out.rows.size(); ++r) fill(numbers_[r], row, out.dome, out.rows[r]);
  }

  static void fill(const std::vector<int>& numbers, const std::vector<int8_t>& row, int dome,
                   ShadowLights::Rows& rows) {
    for (const int number : numbers) {
      rows.ofLight.push_back(number < 0 ? int8_t{-1} : row[static_cast<size_t>(number)]);
      if (rows.ofLight.back() >= 0) rows.used |= 1u << rows.ofLight.back();
    }
    if (dome < 0 || rows.up == glm::vec3(0)) return;
    rows.ofDome = static_cast<int8_t>(dome);
    rows.used |= 1u << dome;
  }

  const FrameData& frame_;
  const Metric& metric_;
  std::vector<std::vector<Known>> known_;  // of the frame's shadings
  std::vector<LightSource> lights_;
  std::vector<std::vector<int>> numbers_;  // beside ShadowLights::rows
};

}  // namespace

std::vector<uint32_t> lampsOf(const FrameData& frame, const Metric& metric, const glm::vec3& light) {
  std::vector<uint32_t> lamps;
  const std::vector<scene::Instance>& instances = frame.snapshot->instances;
  for (uint32_t i = 0; i < instances.size(); ++i)
    if (!isLit(frame.snapshot->shadings[instances[i].shading]) && isLamp(instances[i], light, metric))
      lamps.push_back(i);
  return lamps;
}

ShadowLights findShadowLights(const FrameData& frame, const Metric& metric, bool casts) {
  return Finder(frame, metric).find(casts);
}

}  // namespace gluray::render
