#include "bench/light/compare_rays.h"

#include "bench/data/orbit.h"
#include "bench/data/report.h"
#include "bench/light/rays.h"
#include "render/lights/rig.h"

namespace gluray::bench {
namespace {

BareAim aimOf(const Settings& settings, RayUse use) {
  BareAim aim;
  if (use == RayUse::occlusion) {
    aim.length = 2 * double{settings.ao.radius} * kDataReach;
    return aim;
  }
  const render::Directions world =
      render::sceneDirections(glm::dmat4(1), static_cast<int>(settings.lights.up));
  const glm::vec3 key = world.towards(settings.lights.azimuth, settings.lights.elevation);
  aim.towardsLight = true, aim.light = {key.x, key.y, key.z}, aim.angle = settings.shadows.size;
  return aim;
}

}  // namespace

ComparedRays compareRays(Stage& stage, RayUse use, int threads, int rounds) {
  constexpr int kMore = 5;
  const BareRays bare =
      shootBareRays(stage.mesh(), orbitPose(0, 360), aimOf(stage.settings(), use), threads, rounds);
  Way one{scene::LightSampling::Mode::moving, {1, false}, 4, true};
  one.more = {use == RayUse::occlusion ? "shadows=off" : "ao=off", "ao.samples=16", "shadows.samples=16"};
  Way more = one;
  more.rays.perPixel = kMore;
  std::vector<double> seconds;
  Image image;
  for (int round = 0; round < rounds; ++round) {
    const double base = stage.trace(0, one, image).wall;
    seconds.push_back(stage.trace(0, more, image).wall - base);
  }
  const auto rays = static_cast<double>(bare.rays);
  return {(kMore - 1) * rays / median(seconds), rays / bare.seconds};
}

}  // namespace gluray::bench
