#include "render/lights/relit.h"

#include "render/lights/light_conversion.h"
#include "render/lights/light_file.h"
#include "render/lights/rig.h"
#include "render/local/lighting_space.h"
#include "scene/secondary_scene.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {
namespace {

using scene::FragmentLight;
using scene::LightSource;

/// Ambient light stays.
void dim(scene::Shading& s, float factor) {
  const auto scale = [&](glm::vec4& color) { color = glm::vec4(glm::vec3(color) * factor, color.a); };
  for (scene::Light& light : s.lights) scale(light.diffuse), scale(light.specular);
  for (FragmentLight& light : s.fragment.lights) light.color *= factor, light.highlight *= factor;
}

/// The sum of the diffuse colours of a lit shading's lights, of the shading where it is brightest; white
/// where none has lights.
glm::vec3 colorOfLights(const std::vector<scene::Shading>& shadings) {
  const auto most = [](const glm::vec3& c) { return std::max(c.r, std::max(c.g, c.b)); };
  glm::vec3 brightest(0);
  for (const scene::Shading& s : shadings) {
    if (!isLit(s)) continue;
    glm::vec3 sum(0);
    for (const scene::Light& light : s.lights) sum += glm::vec3(light.diffuse);
    for (const FragmentLight& light : s.fragment.lights) sum += light.color;
    if (most(sum) > most(brightest)) brightest = sum;
  }
  return most(brightest) > 0 ? brightest / most(brightest) : glm::vec3(1);
}

class Relighter {
 public:
  /// Without a rig, the program's lights stay.
  Relighter(const scene::Snapshot& s, const Rig* rig, const Viewer& away, Relit& out)
      : snapshot_(s), rig_(rig), away_(away), out_(out), made_(s.shadings.size()) {}

  void relightAll() {
    for (const scene::Instance& instance : snapshot_.instances) out_.shadingOf.push_back(shadingOf(instance));
    for (size_t i = 0; i < snapshot_.instances.size(); ++i) placeLighting(i);
    if (!rig_ || !snapshot_.secondaryScene) return;
    out_.secondaryShadings = snapshot_.secondaryScene->shadings;
    for (scene::Shading& s : out_.secondaryShadings)
      if (isLit(s)) lightByRig(s);
  }

 private:
  /// Instances share a shading whose lighting spaces lie alike.
  struct Made {
    uint32_t shading;
    glm::dmat4 eyeFromLighting;
  };

  uint32_t shadingOf(const scene::Instance& instance) {
    const scene::Shading& shading = snapshot_.shadings.at(instance.shading);
    const glm::dmat4 space = isLit(shading) ? eyeFromLighting(instance, shading, away_) : glm::dmat4(1);
    const double reach = glm::length(glm::dvec3(instance.eyeFromObject[3]));
    std::vector<Made>& known = made_[instance.shading];
    for (const Made& made : known)
      if (isNearly(made.eyeFromLighting, space, reach)) return made.shading;
    const auto index = static_cast<uint32_t>(out_.shadings.size());
    known.push_back({index, space});
    out_.shadings.push_back(shading);
    out_.firstSource.push_back(isProgram(shading) ? shading.fragment.lights.size() : shading.lights.size());
    if (isLit(shading)) relightOne(out_.shadings.back(), out_.firstSource.back(), glm::inverse(space));
    return index;
  }

  /// Lights from elsewhere than the viewer need the points that they shine on.
  void placeLighting(size_t i) {
    const scene::Instance& instance = snapshot_.instances[i];
    const scene::Shading& shading = snapshot_.shadings[instance.shading];
    if (!isProgram(shading) || !isLit(shading)) return;
    const glm::mat4 lighting(lightingFromObject(instance, shading, away_));
    if (lighting == instance.lightingFromObject) return;
    if (out_.instances.empty()) out_.instances = snapshot_.instances;
    out_.instances[i].lightingFromObject = lighting;
  }

  /// Leaves it the program's lights, dimmed, or the rig's light at the viewer alone.
  void lightByRig(scene::Shading& s) const {
    if (rig_->program > 0) return dim(s, rig_->program);
    s.lights.clear(), s.fragment.lights.clear();
    if (!(rig_->headlight > 0)) return;
    if (isProgram(s))
      s.fragment.lights.emplace_back().color = glm::vec3(rig_->headlight);
    else
      s.lights.push_back(fixedLight(headlightOf(rig_->headlight, away_)));
  }

  void relightOne(scene::Shading& s, size_t& first, const glm::dmat4& lightingFromEye) const {
    if (rig_) lightByRig(s);
    if (isProgram(s)) {
      first = s.fragment.lights.size();
      for (const LightSource& l : out_.sources) s.fragment.lights.push_back(programLight(l, lightingFromEye));
      return;
    }
    first = s.lights.size();
    for (const LightSource& l : out_.sources) s.lights.push_back(fixedLight(l));
  }

  const scene::Snapshot& snapshot_;
  const Rig* rig_;
  const Viewer& away_;
  Relit& out_;
  std::vector<std::vector<Made>> made_;  // of the snapshot's shadings
};

}  // namespace

std::shared_ptr<const Relit> relight(const scene::Snapshot& snapshot, const RaySetup& eyeRays) {
  const Settings::Lights& settings = snapshot.settings.lights;
  if (settings.rig == LightRig::program && settings.file.empty()) return nullptr;
  const auto added = lightsOf(settings.file);
  const Directions camera = cameraDirections(eyeRays, snapshot.camera.viewport);
  std::optional<Rig> rig = makeRig(snapshot.settings, snapshot.eyeFromWorld, camera);
  if (rig && rig->program > 0) rig->lights.front().color = colorOfLights(snapshot.shadings);
  if (!rig && (!added || added->empty())) return nullptr;
  auto relit = std::make_shared<Relit>();
  if (rig) relit->sources = rig->lights, relit->dome = rig->dome;
  if (added)
    for (const FileLight& light : *added) relit->sources.push_back(placed(light, snapshot.eyeFromWorld));
  Relighter(snapshot, rig ? &*rig : nullptr, eyeRays.step, *relit).relightAll();
  return relit;
}

}  // namespace gluray::render
