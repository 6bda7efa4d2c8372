#include "bench/light/stage.h"

#include "bench/data/isosurface.h"
#include "bench/data/orbit.h"
#include "bench/data/wavelet.h"
#include "bench/render/wavelet_snapshot.h"
#include "render/float_guard.h"
#include "settings/values.h"

#include <chrono>
#include <cmath>
#include <stdexcept>

namespace gluray::bench {
namespace {

TriangleMesh meshOf(double millions) {
  const Volume volume = wavelet();
  const auto [low, high] = volume.range();
  return isosurfaces(volume, evenIsovalues(low, high, waveletSurfaces(millions)));
}

/// False where there is no such setting.
bool set(Session& session, const std::string& name, const std::string& value) {
  const Row* row = findSetting(name);
  if (!row) return false;
  const std::string problem = readValue(*row, value, session);
  if (!problem.empty()) throw std::runtime_error(name + ": " + problem);
  return true;
}

Settings settingsOf(const StageOptions& options) {
  Session session;
  session.settings.bvh = BvhQuality::full;
  session.settings.threads = options.threads;
  for (const std::string& setting : options.settings) {
    const size_t equals = setting.find('=');
    if (equals == std::string::npos || !set(session, setting.substr(0, equals), setting.substr(equals + 1)))
      throw std::runtime_error("there is no setting " + setting);
  }
  return session.settings;
}

}  // namespace

Stage::Stage(const StageOptions& options)
    : mesh_(meshOf(options.millionTriangles)), arena_(options.threads), snapshot_(waveletSnapshot(mesh_)) {
  snapshot_.settings = settingsOf(options);
  lookFrom(snapshot_, orbitPose(0, 360));
  const render::FloatGuard guard;
  world_.update(snapshot_, arena_);
}

double Stage::trace(int degree, const Way& way, Image& image) {
  scene::Snapshot s = snapshot_;
  lookFrom(s, orbitPose(degree, 360));
  s.view = way.view;
  s.lightSampling.mode = way.mode;
  Session session{s.settings};
  for (const char* name : {"ao.samples", "shadows.samples"})
    if (way.samples > 0) set(session, name, std::to_string(way.samples));
  for (const char* name : {"ao", "shadows"})
    if (!way.light) set(session, name, "off");
  s.settings = session.settings;
  render::LightHistories none;
  const render::FloatGuard guard;
  world_.update(s, arena_);
  const auto start = std::chrono::steady_clock::now();
  render::traceImage(s, world_, arena_, image, {way.fresh ? &none : &histories_, way.rays});
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double psnr(const Image& picture, const Image& reference) {
  double sum = 0;
  size_t count = 0;
  for (size_t i = 0; i < reference.color.size(); ++i) {
    if (reference.depth[i] == Image::kMiss) continue;
    for (int c = 0; c < 24; c += 8) {
      const double d = static_cast<double>(picture.color[i] >> c & 255) -
                       static_cast<double>(reference.color[i] >> c & 255);
      sum += d * d, ++count;
    }
  }
  return 10 * std::log10(255.0 * 255 * static_cast<double>(count) / std::max(sum, 1e-9));
}

}  // namespace gluray::bench
