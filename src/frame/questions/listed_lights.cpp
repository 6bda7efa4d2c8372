#include "frame/questions/listed_lights.h"

#include "render/lights/light_conversion.h"
#include "render/lights/light_file.h"
#include "render/lights/rig.h"
#include "render/local/lighting_space.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace gluray::frame {
namespace {

using From = ListedLight::From;
using scene::LightSource;

class Lister {
 public:
  explicit Lister(const scene::Snapshot& s)
      : snapshot_(s),
        viewer_(s),
        rig_(render::makeRig(s.settings, s.eyeFromWorld, viewer_.axes())),
        axes_(render::rigDirections(s.settings, s.eyeFromWorld, viewer_.axes())) {}

  std::vector<ListedLight> all() {
    rig_ ? addRig() : addProgram();
    if (const auto added = render::lightsOf(snapshot_.settings.lights.file))
      for (size_t i = 0; i < added->size(); ++i)
        add("file " + std::to_string(i + 1), From::file, render::placed((*added)[i], snapshot_.eyeFromWorld));
    return std::move(lights_);
  }

 private:
  void addRig() {
    static constexpr std::string_view kThree[] = {"key", "fill", "back"};
    const bool sun = snapshot_.settings.lights.rig == LightRig::sun;
    for (size_t i = 0; i < rig_->lights.size(); ++i)
      add(sun ? "sun" : std::string(kThree[std::min<size_t>(i, 2)]), From::rig, rig_->lights[i]);
    if (rig_->headlight > 0) addHeadlight("headlight", From::rig, glm::vec3(1), rig_->headlight);
    if (!rig_->dome.shines()) return;
    ListedLight& sky = lights_.emplace_back();
    sky.name = "sky", sky.from = From::rig, sky.dome = true;
    sky.source.color = glm::vec3(1), sky.source.strength = rig_->dome.sky.r;
  }

  /// Those of the first surface that is lit.
  void addProgram() {
    for (const scene::Instance& instance : snapshot_.instances) {
      const scene::Shading& shading = snapshot_.shadings[instance.shading];
      if (!scene::isLit(shading) || instance.ground) continue;
      size_t number = 0;
      const auto name = [&] { return "program " + std::to_string(++number); };
      if (!scene::isProgram(shading))
        for (const scene::Light& light : shading.lights) add(name(), From::program, render::sourceOf(light));
      const auto eyeFrom = render::eyeFromLighting(instance, shading, viewer_.away());
      for (const scene::FragmentLight& light : shading.fragment.lights)
        if (light.kind == scene::FragmentLight::headlight)
          addHeadlight(name(), From::program, light.color, 1);
        else
          add(name(), From::program, render::sourceOf(light, eyeFrom));
      return;
    }
  }

  void addHeadlight(std::string name, From from, const glm::vec3& color, float strength) {
    LightSource light;
    light.color = color, light.strength = strength;
    light.direction = glm::vec3(-viewer_.axes().front);
    add(std::move(name), from, light).followsViewer = true;
  }

  ListedLight& add(std::string name, From from, const LightSource& source) {
    ListedLight& light = lights_.emplace_back();
    light.name = std::move(name), light.from = from, light.source = source;
    if (source.kind == LightSource::Kind::distant)
      light.angles = axes_.anglesOf(-glm::dvec3(source.direction));
    light.source.direction = seen(source.direction), light.source.position = seen(source.position);
    return light;
  }

  /// In the axes that the viewer sees.
  glm::vec3 seen(const glm::vec3& v) const {
    const render::Directions& d = viewer_.axes();
    const glm::dvec3 eye(v);
    return {glm::dot(eye, d.right), glm::dot(eye, d.up), glm::dot(eye, d.front)};
  }

  const scene::Snapshot& snapshot_;
  const Viewer viewer_;
  const std::optional<render::Rig> rig_;
  const render::Directions axes_;
  std::vector<ListedLight> lights_;
};

}  // namespace

std::vector<ListedLight> listLights(const scene::Snapshot& snapshot) { return Lister(snapshot).all(); }

glm::dvec2 anglesOfHighlight(const scene::Snapshot& s, const glm::dvec3& point, const glm::dvec3& normal) {
  const Viewer viewer(s);
  const glm::dvec3 towards = viewer.directionFrom(point);
  const glm::dvec3 light = 2 * glm::dot(normal, towards) * normal - towards;
  return render::rigDirections(s.settings, s.eyeFromWorld, viewer.axes()).anglesOf(light);
}

}  // namespace gluray::frame
