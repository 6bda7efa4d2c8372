#include "render/volume_light/volume_light.h"

#include "render/frame_data/frame_data.h"
#include "render/integrators/metric.h"
#include "render/integrators/occluders.h"
#include "render/lights/light_conversion.h"
#include "render/lights/light_file.h"
#include "render/lights/rig.h"
#include "render/volume_light/light_points.h"
#include "render/volume_light/medium.h"
#include "scene/box_corner.h"
#include "scene/effects.h"
#include "scene/secondary_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace gluray::render {
namespace {

/// Of products of matrices that programs keep as floats, with their inverses.
constexpr double kRounding = 1e-3;

/// Whether matrices are equal up to the rounding of their products.
template <class Matrix>
bool areNear(const Matrix& a, const Matrix& b) {
  for (int c = 0; c < 4; ++c) {
    double most = 0;
    for (int r = 0; r < 4; ++r) most = std::max({most, std::abs(double{a[c][r]}), std::abs(double{b[c][r]})});
    for (int r = 0; r < 4; ++r)
      if (!(std::abs(double{a[c][r]} - double{b[c][r]}) <= kRounding * most)) return false;
  }
  return true;
}

/// The diagonal of the box around a volume and the surfaces of its view, eye space.
float diagonalOf(const VolumeInView& in, const accel::Bounds& surfaces) {
  const scene::Medium& medium = *in.volume.medium;
  const glm::dmat4 eyeFromTexture = in.volume.eyeFromData * glm::inverse(medium.textureFromData);
  glm::dvec3 lower(std::numeric_limits<double>::infinity()), upper(-lower);
  const auto add = [&](const glm::vec3& least, const glm::vec3& most, const glm::dmat4& eyeFromBox) {
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 p(eyeFromBox * glm::dvec4(scene::boxCorner(least, most, corner), 1));
      lower = glm::min(lower, p), upper = glm::max(upper, p);
    }
  };
  add(medium.lower, medium.upper, eyeFromTexture);
  const auto& around = in.view.secondaryScene;
  const glm::dmat4 viewFromWorld = around ? around->viewFromWorld : glm::dmat4(1);
  if (!surfaces.empty())
    add(surfaces.lower, surfaces.upper, in.view.eyeFromWorld * glm::inverse(viewFromWorld));
  return static_cast<float>(glm::length(upper - lower));
}

scene::VolumeLight volumeLight(const scene::LightSource& source) {
  const scene::Light from = fixedLight(source);
  scene::VolumeLight light;
  light.diffuse = glm::vec3(from.diffuse), light.specular = glm::vec3(from.specular);
  light.positional = from.position.w != 0;
  if (!light.positional) {
    light.direction = -glm::normalize(glm::vec3(from.position));
    return light;
  }
  light.position = glm::vec3(from.position) / from.position.w;
  light.direction = glm::normalize(from.spotDirection);
  light.attenuation = from.attenuation;
  light.coneAngle = from.spotCutoff, light.exponent = from.spotExponent;
  return light;
}

/// Where a light stands, with the matrix from its space to eye space.
LightPoints::Source sourceAt(const scene::VolumeLight& light, const glm::dmat4& eyeFromLight) {
  return {light.positional, glm::vec3(eyeFromLight * glm::dvec4(light.position, 1)),
          -glm::vec3(glm::normalize(glm::dmat3(eyeFromLight) * glm::dvec3(light.direction)))};
}

/// Whether the viewer sees none of the shadows, because each is behind what casts it.
bool isAtViewer(const LightPoints::Source& source, const Metric& metric, float diagonal) {
  constexpr double kNear = 1e-3;
  const glm::dvec3 away(metric.away);
  const bool parallel = std::abs(metric.away.w) * diagonal <= kNear * glm::length(away);
  if (!source.positional)
    return parallel && glm::length(glm::dvec3(source.towards) + glm::normalize(away)) < kNear;
  return !parallel && glm::length(glm::dvec3(source.position) - away / metric.away.w) <= kNear * diagonal;
}

class IlluminationFinder {
 public:
  IlluminationFinder(const VolumeInView& in, const FrameData& frame, const Metric& metric,
                     const LightPoints& points, float diagonal, SampleIllumination& out)
      : in_(in), frame_(frame), metric_(metric), points_(points), diagonal_(diagonal), out_(out) {}

  void addLights() {
    const scene::VolumeShading& shading = in_.volume.medium->volume.shading;
    if (!shading.enabled()) return;
    addRig();
    const glm::dmat4 eyeFromProgram =
        glm::dmat4(out_.eyeFromTexture) * glm::inverse(glm::dmat4(shading.eyeFromTexture));
    for (const scene::VolumeLight& light : shading.lights)
      out_.rows.push_back(out_.programShare > 0 && !shading.isFromViewer()
                              ? rowOf(sourceAt(light, eyeFromProgram), light)
                              : -1);
  }

 private:
  /// The lights of the settings.
  void addRig() {
    const Settings& settings = in_.view.settings;
    if (settings.look == Look::honest) return;
    const Directions camera = cameraDirections(frame_.eyeRays, in_.view.camera.viewport);
    if (const std::optional<Rig> rig = makeRig(settings, in_.view.eyeFromWorld, camera)) {
      out_.programShare = rig->program;
      for (const scene::LightSource& light : rig->lights) add(light);
      if (rig->headlight > 0) add(headlightOf(rig->headlight, metric_.away));
      out_.ambient = 0.5f * (rig->dome.sky + rig->dome.ground);
    }
    if (const auto file = lightsOf(settings.lights.file))
      for (const FileLight& light : *file) add(placed(light, in_.view.eyeFromWorld));
  }

  void add(const scene::LightSource& source) {
    const scene::VolumeLight light = volumeLight(source);
    out_.added.push_back({light, rowOf(sourceAt(light, glm::dmat4(1)), light)});
  }

  /// The row of a light's shadows; -1: it has none.
  int rowOf(const LightPoints::Source& source, const scene::VolumeLight& light) {
    constexpr size_t kMost = 4;
    if (!scene::wantsShadows(in_.view.settings) || out_.shadows.size() >= kMost ||
        isAtViewer(source, metric_, diagonal_) || light.diffuse + light.specular == glm::vec3(0))
      return -1;
    std::vector<float> row = points_.arriving(source);
    const float strength = in_.view.settings.shadows.strength;
    for (float& arrives : row) arrives = 1 - strength * (1 - arrives);
    out_.shadows.push_back(std::move(row));
    return static_cast<int>(out_.shadows.size()) - 1;
  }

  const VolumeInView& in_;
  const FrameData& frame_;
  const Metric& metric_;
  const LightPoints& points_;
  const float diagonal_;
  SampleIllumination& out_;
};

bool changesNothing(const SampleIllumination& light) {
  return light.occlusion.empty() && light.shadows.empty() && light.added.empty() && light.programShare == 1 &&
         light.ambient == glm::vec3(0);
}

}  // namespace

bool VolumeLights::Surroundings::isLike(const Surroundings& other) const {
  const auto same = [](const Surface& a, const Surface& b) {
    return a.geometry == b.geometry && areNear(a.dataFromObject, b.dataFromObject);
  };
  return media == other.media &&
         std::equal(surfaces.begin(), surfaces.end(), other.surfaces.begin(), other.surfaces.end(), same) &&
         std::equal(latticeFromData.begin(), latticeFromData.end(), other.latticeFromData.begin(),
                    other.latticeFromData.end(), areNear<glm::mat4>);
}

VolumeLights::Surroundings VolumeLights::surroundingsOf(const VolumeInView& in,
                                                        const std::vector<PlacedLattice>& media) {
  Surroundings around;
  const glm::dmat4 dataFromEye = glm::inverse(in.volume.eyeFromData);
  const glm::mat4 worldFromData(glm::inverse(in.view.eyeFromWorld) * in.volume.eyeFromData);
  for (size_t i = 0; i < scene::countAll(in.view); ++i) {
    const scene::Instance& instance = scene::instanceOf(in.view, i);
    around.surfaces.push_back({instance.mesh->geometryId, dataFromEye * instance.eyeFromObject});
  }
  for (const PlacedLattice& medium : media) {
    around.media.push_back(medium.extinction);
    around.latticeFromData.push_back(medium.latticeFromWorld * worldFromData);
  }
  return around;
}

std::shared_ptr<const SampleIllumination> VolumeLights::arriving(const VolumeInView& in,
                                                                 const accel::World& world, Media& media,
                                                                 Arena& arena) {
  const Settings& settings = in.view.settings;
  const scene::Medium& medium = *in.volume.medium;
  const PlacedLattice own = media.placed(in.volume, in.view.eyeFromWorld, arena);
  if (!own.extinction) return nullptr;
  std::vector<PlacedLattice> all{own};
  for (PlacedLattice& other : media.of(in.view, arena)) all.push_back(std::move(other));
  Image image;
  image.resize(1, 1, 1);
  FrameData frame(in.view, world, image);
  const Metric metric(frame);
  const Occluders occluders(in.view, frame.surfaces);
  const float diagonal = diagonalOf(
      in, countAll(in.view) == 0 ? accel::Bounds{glm::vec3(1), glm::vec3(-1)} : world.lightBounds());
  auto light = std::make_shared<SampleIllumination>();
  light->keepsBrightness = settings.autoExposure && settings.look != Look::honest;
  light->size = own.extinction->size, light->lower = medium.lower, light->upper = medium.upper;
  const glm::dmat4 eyeFromTexture = in.volume.eyeFromData * glm::inverse(medium.textureFromData);
  light->eyeFromTexture = glm::mat4(eyeFromTexture);
  light->eyeFromGradient = glm::mat3(glm::transpose(glm::inverse(glm::dmat3(in.volume.eyeFromData))));
  arena.execute([&] {
    const LightPoints points(frame, metric, occluders, all);
    if (scene::wantsOcclusion(settings)) {
      const float radius = settings.ao.distance > 0 ? settings.ao.distance : settings.ao.radius * diagonal;
      light->occlusion = occlusionOf(surroundingsOf(in, all), points, radius, settings.ao.strength);
    }
    IlluminationFinder(in, frame, metric, points, diagonal, *light).addLights();
  });
  return changesNothing(*light) ? nullptr : light;
}

std::vector<float> VolumeLights::occlusionOf(Surroundings around, const LightPoints& points, float radius,
                                             float strength) {
  const auto isNear = [](float a, float b) { return std::abs(a - b) <= kRounding * std::max(a, b); };
  const auto found = std::find_if(known_.begin(), known_.end(), [&](const Occlusion& known) {
    return isNear(known.radius, radius) && known.strength == strength && known.around.isLike(around);
  });
  if (found != known_.end()) {
    std::rotate(found, found + 1, known_.end());
    return known_.back().values;
  }
  std::vector<float> values = points.openness(radius);
  for (float& open : values) open = 1 - strength * (1 - open);
  constexpr size_t kMost = 4;
  if (known_.size() >= kMost) known_.erase(known_.begin());
  known_.push_back({std::move(around), radius, strength, values});
  return values;
}

}  // namespace gluray::render
