#include "saved/program/render.h"

#include "saved/shot/shot.h"
#include "settings/values.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace gluray::saved {
namespace {

Fit fitOf(const std::string& word) {
  if (word == "all") return Fit::all;
  if (word == "crop") return Fit::crop;
  if (word == "stretch") return Fit::stretch;
  throw std::runtime_error("fit: use all, crop or stretch");
}

/// Smooth edges in pictures of other sizes than the window's, unless the user chose the samples.
constexpr int kEdgeSamples = 4;

bool choosesSamples(std::span<const char* const> settings) {
  return std::any_of(settings.begin(), settings.end(),
                     [](std::string_view text) { return text.starts_with("spp="); });
}

/// Settings with other values; empty: the same. Throws if they cannot be read.
std::function<Settings(const Settings&)> changed(std::span<const char* const> values) {
  if (values.empty()) return {};
  return [values](const Settings& settings) {
    Session session;
    session.settings = settings;
    for (const std::string_view text : values) {
      const size_t equals = text.find('=');
      const std::string name(text.substr(0, equals));
      const Row* const row = findSetting(name);
      if (!row) throw std::runtime_error(unknownSetting(name));
      const std::string why =
          readValue(*row, equals == std::string_view::npos ? "" : text.substr(equals + 1), session);
      if (!why.empty()) throw std::runtime_error(name + ": " + why);
    }
    return session.settings;
  };
}

/// One picture. False: the sink has ended it.
bool renderOne(Shot& shot, int picture, int firstBand, const std::string& facts,
               const GlurayRenderSink& sink) {
  if (!sink.begin(sink.user, picture, shot.size().x, shot.size().y, shot.bandRows(), facts.c_str()))
    return false;
  for (const std::string& line : shot.notes()) sink.note(sink.user, line.c_str());
  for (int band = firstBand; band < shot.bands(); ++band) {
    const std::vector<uint32_t> pixels = shot.band(band);
    const int rows = static_cast<int>(pixels.size() / static_cast<size_t>(shot.size().x));
    if (!sink.rows(sink.user, band, rows, pixels.data())) return false;
  }
  return sink.end(sink.user) != 0;
}

bool render(const GlurayRenderRequest& request, const GlurayRenderSink& sink) {
  if (request.version != kGlurayRenderVersion)
    throw std::runtime_error("install GLuRay again: its library is of another version");
  SavedScene scene = readScene(request.scene);
  const std::span settings(request.settings, static_cast<size_t>(request.settingCount));
  const std::string facts = scene.facts.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  ShotOptions options{.size = {request.width, request.height},
                      .fit = fitOf(request.fit),
                      .transparent = request.transparent != 0,
                      .overlays = request.overlays != 0,
                      .settings = changed(settings),
                      .edgeSamples = choosesSamples(settings) ? 1 : kEdgeSamples};
  frame::Renderer renderer;  // keeps the structures of meshes from picture to picture
  for (int picture = request.firstPicture; picture < request.pictures; ++picture) {
    options.turn = 360.0 * picture / request.pictures;
    options.overlays = options.overlays && request.pictures == 1;
    Shot shot(scene, options, renderer);
    const int firstBand = picture == request.firstPicture ? request.firstBand : 0;
    if (!renderOne(shot, picture, firstBand, facts, sink)) return false;
  }
  return true;
}

}  // namespace
}  // namespace gluray::saved

__attribute__((visibility("default"))) int glurayRender(const GlurayRenderRequest* request,
                                                        const GlurayRenderSink* sink, char* why,
                                                        unsigned long whyBytes) {
  std::snprintf(why, whyBytes, "%s", "");
  try {
    return gluray::saved::render(*request, *sink);
  } catch (const std::exception& e) {
    std::snprintf(why, whyBytes, "%s", e.what());
    return 0;
  }
}
