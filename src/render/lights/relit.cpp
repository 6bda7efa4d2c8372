#include "render/lights/relit.h"

#include "render/lights/light_conversion.h"
#include "render/lights/rig.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {
namespace {

using scene::FragmentLight;
using scene::LightSource;

bool isProgram(const scene::Shading& s) { return s.fragment.model != scene::FragmentShading::Model::off; }
bool isLit(const scene::Shading& s) {
  return isProgram(s) ? s.fragment.model != scene::FragmentShading::Model::unlit : s.lighting;
}

/// The light at the viewer for fixed function: in parallel views as far away as the viewer is.
LightSource headlight(float strength, const Viewer& away) {
  LightSource light;
  light.strength = strength;
  light.direction = glm::vec3(glm::normalize(glm::dvec3(away)));
  if (away.w == 0) return light;
  light.kind = LightSource::Kind::point;
  light.position = glm::vec3(glm::dvec3(away) / away.w);
  return light;
}

class Relighter {
 public:
  Relighter(const scene::Snapshot& s, const Rig& rig, const Viewer& away, Relit& out)
      : snapshot_(s), rig_(rig), away_(away), out_(out), made_(s.shadings.size()) {}

  void relightAll() {
    out_.sources = rig_.lights;
    out_.dome = rig_.dome;
    for (const scene::Instance& instance : snapshot_.instances) out_.shadingOf.push_back(shadingOf(instance));
  }

 private:
  /// Instances share a shading whose lighting spaces lie alike.
  struct Made {
    uint32_t shading;
    glm::dmat4 eyeFromLighting;
  };

  uint32_t shadingOf(const scene::Instance& instance) {
    const scene::Shading& shading = snapshot_.shadings.at(instance.shading);
    const glm::dmat4 space = isProgram(shading) ? eyeFromLighting(instance) : glm::dmat4(1);
    const double reach = glm::length(glm::dvec3(instance.eyeFromObject[3]));
    std::vector<Made>& known = made_[instance.shading];
    for (const Made& made : known)
      if (isNearly(made.eyeFromLighting, space, reach)) return made.shading;
    const auto index = static_cast<uint32_t>(out_.shadings.size());
    known.push_back({index, space});
    out_.shadings.push_back(shading);
    out_.firstSource.push_back(0);
    if (isLit(shading)) relightOne(out_.shadings.back(), out_.firstSource.back(), glm::inverse(space));
    return index;
  }

  void relightOne(scene::Shading& s, size_t& first, const glm::dmat4& lightingFromEye) const {
    s.lights.clear(), s.fragment.lights.clear();
    if (isProgram(s)) {
      if (rig_.headlight > 0) s.fragment.lights.push_back({.color = glm::vec3(rig_.headlight)});
      first = s.fragment.lights.size();
      for (const LightSource& l : out_.sources) s.fragment.lights.push_back(programLight(l, lightingFromEye));
      return;
    }
    if (rig_.headlight > 0) s.lights.push_back(fixedLight(headlight(rig_.headlight, away_)));
    first = s.lights.size();
    for (const LightSource& l : out_.sources) s.lights.push_back(fixedLight(l));
  }

  const scene::Snapshot& snapshot_;
  const Rig& rig_;
  const Viewer& away_;
  Relit& out_;
  std::vector<std::vector<Made>> made_;  // of the snapshot's shadings
};

}  // namespace

glm::dmat4 eyeFromLighting(const scene::Instance& instance) {
  const glm::dmat4 lighting(instance.lightingFromObject);
  if (isNearly(instance.eyeFromObject, lighting, 0)) return glm::dmat4(1);
  return instance.eyeFromObject * glm::inverse(lighting);
}

bool isNearly(const glm::dmat4& a, const glm::dmat4& b, double reach) {
  constexpr double kRounded = 1e-5;
  for (int c = 0; c < 4; ++c) {
    const double size = glm::length(glm::dvec3(a[c])) + (c == 3 ? reach : 0);
    if (glm::length(glm::dvec3(a[c] - b[c])) > kRounded * size) return false;
  }
  return true;
}

std::shared_ptr<const Relit> relight(const scene::Snapshot& snapshot, const Viewer& away) {
  const std::optional<Rig> rig = makeRig(snapshot.settings, snapshot.eyeFromWorld);
  if (!rig) return nullptr;
  auto relit = std::make_shared<Relit>();
  Relighter(snapshot, *rig, away, *relit).relightAll();
  return relit;
}

}  // namespace gluray::render
