#include "saved/program/render.h"

#include "saved/exr/exr_writer.h"
#include "saved/shot/linear_color.h"
#include "saved/shot/shot.h"
#include "settings/values.h"

#include <cstdio>
#include <exception>
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

/// Changes settings of all batches.
void change(SavedScene& scene, std::span<const char* const> settings) {
  for (SavedBatch& batch : scene.batches) {
    auto changed = std::make_shared<scene::Snapshot>(*batch.snapshot);
    Session session;
    session.settings = changed->settings;
    for (const std::string_view text : settings) {
      const size_t equals = text.find('=');
      const std::string name(text.substr(0, equals));
      const Row* const row = findSetting(name);
      if (!row) throw std::runtime_error(unknownSetting(name));
      const std::string why =
          readValue(*row, equals == std::string_view::npos ? "" : text.substr(equals + 1), session);
      if (!why.empty()) throw std::runtime_error(name + ": " + why);
    }
    changed->settings = session.settings;
    batch.snapshot = std::move(changed);
  }
}

/// The pixels of a band as floats, from its top.
std::vector<glm::vec4> floatsOf(Shot& shot, int band, int values) {
  std::vector<glm::vec4> colors =
      shot.wideBand(band, values == kGlurayLinear ? Shot::Range::open : Shot::Range::limited);
  if (values == kGlurayLinear)
    for (glm::vec4& color : colors) color = lightOf(color);
  return colors;
}

/// Whether the sink goes on.
template <class Pixel>
bool give(const Shot& shot, int band, const std::vector<Pixel>& pixels, const GlurayRenderSink& sink) {
  const int rows = static_cast<int>(pixels.size() / static_cast<size_t>(shot.size().x));
  return sink.rows(sink.user, band, rows, pixels.data()) != 0;
}

/// What OpenEXR files have.
std::string exrHeader() {
  nlohmann::json channels = nlohmann::json::array();
  for (const char* name : {"R", "G", "B", "A"}) channels.push_back({{"name", name}, {"color", true}});
  return nlohmann::json{{"channels", channels}}.dump();
}

/// One picture. False: the sink has ended it.
bool renderOne(Shot& shot, int picture, int firstBand, const std::string& facts,
               const GlurayRenderRequest& request, const GlurayRenderSink& sink) {
  if (!sink.begin(sink.user, picture, shot.size().x, shot.size().y, shot.bandRows(), facts.c_str()))
    return false;
  for (const std::string& line : shot.notes()) sink.note(sink.user, line.c_str());
  for (int band = firstBand; band < shot.bands(); ++band) {
    const bool goesOn = request.values == kGlurayBytes
                            ? give(shot, band, shot.band(band), sink)
                            : give(shot, band, floatsOf(shot, band, request.values), sink);
    if (!goesOn) return false;
  }
  return sink.end(sink.user) != 0;
}

bool render(const GlurayRenderRequest& request, const GlurayRenderSink& sink) {
  if (request.version != kGlurayRenderVersion)
    throw std::runtime_error("install GLuRay again: its library is of another version");
  SavedScene scene = readScene(request.scene);
  change(scene, {request.settings, static_cast<size_t>(request.settingCount)});
  const std::string facts = scene.facts.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  ShotOptions options{.size = {request.width, request.height},
                      .fit = fitOf(request.fit),
                      .transparent = request.transparent != 0,
                      .overlays = request.overlays != 0};
  if (request.values == kGlurayLinear) {
    if (!canWriteExr())
      throw std::runtime_error("this GLuRay was built without OpenEXR: use a name that ends in .png");
    if (!sink.channels(sink.user, 4, exrHeader().c_str())) return false;
  }
  frame::Renderer renderer;  // keeps the structures of meshes from picture to picture
  for (int picture = request.firstPicture; picture < request.pictures; ++picture) {
    options.turn = 360.0 * picture / request.pictures;
    options.overlays = options.overlays && request.pictures == 1;
    Shot shot(scene, options, renderer);
    const int firstBand = picture == request.firstPicture ? request.firstBand : 0;
    if (!renderOne(shot, picture, firstBand, facts, request, sink)) return false;
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
