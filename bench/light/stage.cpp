#include "bench/light/stage.h"

#include "bench/data/isosurface.h"
#include "bench/data/orbit.h"
#include "bench/data/wavelet.h"
#include "bench/light/lines.h"
#include "bench/render/settings.h"
#include "bench/render/wavelet_snapshot.h"
#include "render/tiles/float_guard.h"

#include <chrono>
#include <ctime>

namespace gluray::bench {
namespace {

TriangleMesh meshOf(const StageOptions& options) {
  if (options.lines > 0) return {};
  const Volume volume = wavelet();
  const auto [low, high] = volume.range();
  return isosurfaces(volume, evenIsovalues(low, high, waveletSurfaces(options.millionTriangles)));
}

/// Processor time of all threads of this process.
double cpuSeconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

void look(scene::Snapshot& s, int degree) {
  lookFrom(s, orbitPose(degree, 360));
  s.instances[0].lightingFromObject = glm::mat4(s.instances[0].eyeFromObject);
}

}  // namespace

Stage::Stage(const StageOptions& options)
    : mesh_(meshOf(options)),
      arena_(options.threads),
      snapshot_(waveletSnapshot(mesh_)),
      threads_(options.threads) {
  if (options.width > 0 && options.height > 0) {
    snapshot_.camera.viewport = {0, 0, options.width, options.height};
    snapshot_.region = {0, 0, options.width, options.height};
    snapshot_.camera.clipFromEye[0][0] *= double(options.height) / options.width;
  }
  if (options.lines > 0) {
    snapshot_.instances[0].mesh = fieldLines(options.lines);
    snapshot_.instances[0].impostors.size = 4.0f / glm::vec2(snapshot_.region.width, snapshot_.region.height);
  }
  use({});
  look(snapshot_, 0);
  const render::FloatGuard guard;
  world_.update(snapshot_, all_);
}

void Stage::use(const std::vector<std::string>& settings) {
  snapshot_.settings = {};
  snapshot_.settings.bvh = BvhQuality::full;
  snapshot_.settings.threads = threads_;
  for (const std::string& setting : settings) set(snapshot_.settings, setting);
  histories_.clear();
}

scene::Snapshot Stage::at(int degree, const std::vector<std::string>& more) const {
  scene::Snapshot s = snapshot_;
  look(s, degree);
  for (const std::string& setting : more) set(s.settings, setting);
  return s;
}

double Stage::trace(const scene::Snapshot& s, Image& image) {
  const render::FloatGuard guard;
  world_.update(s, arena_);
  const auto start = std::chrono::steady_clock::now();
  render::traceImage(s, world_, arena_, image, {});
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

FrameTime Stage::trace(int degree, const Way& way, Image& image) {
  scene::Snapshot s = at(degree, way.more);
  s.view = way.view, s.wideColors = way.wide;
  s.lightSampling.mode = way.mode, s.lightSampling.pass = way.pass;
  render::LightHistories none;
  Arena& arena = way.allThreads ? all_ : arena_;
  const render::FloatGuard guard;
  world_.update(s, arena);
  const auto start = std::chrono::steady_clock::now();
  const double before = cpuSeconds();
  render::traceImage(s, world_, arena, image, {way.fresh ? &none : &histories_, way.rays});
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
          cpuSeconds() - before};
}

std::vector<uint8_t> hitsOf(const Image& image) {
  std::vector<uint8_t> hit(image.depth.size());
  for (size_t i = 0; i < hit.size(); ++i) hit[i] = image.depth[i] != Image::kMiss;
  return hit;
}

}  // namespace gluray::bench
