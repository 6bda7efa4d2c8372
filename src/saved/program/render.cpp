#include "saved/program/render.h"

#include "saved/scene/scene_hash.h"
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

ViewCamera cameraOf(const GlurayCamera& c) {
  const auto vector = [](const double(&v)[3]) { return glm::dvec3(v[0], v[1], v[2]); };
  return {vector(c.position), vector(c.focalPoint), vector(c.up), c.viewAngle, c.parallelScale};
}

/// Null: the request has no cameras.
std::shared_ptr<const KnownView> knownViewOf(const SavedScene& scene, const GlurayRenderRequest& request) {
  if (!request.cameras) return nullptr;
  std::vector<scene::SnapshotPtr> batches;
  for (const SavedBatch& batch : scene.batches) batches.push_back(batch.snapshot);
  std::vector<ViewCamera> cameras;
  for (int i = 0; i < request.savedCameraCount; ++i) cameras.push_back(cameraOf(request.savedCameras[i]));
  return std::make_shared<KnownView>(knownView(batches, cameras, request.savedCameraStated != 0));
}

/// What is told about the scene: JSON. Throws std::runtime_error if another scene is wanted.
std::string factsOf(const SavedScene& scene, const char* wantedHash) {
  nlohmann::json facts = scene.facts;
  const std::string hash = hashOf(scene);
  if (wantedHash && hash != wantedHash)
    throw std::runtime_error("the scene is another one than that of the picture");
  facts["hash"] = hash;
  return facts.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
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
  const std::string facts = factsOf(scene, request.sceneHash);
  change(scene, {request.settings, static_cast<size_t>(request.settingCount)});
  ShotOptions options{.size = {request.width, request.height},
                      .fit = fitOf(request.fit),
                      .transparent = request.transparent != 0,
                      .overlays = request.overlays != 0,
                      .known = knownViewOf(scene, request)};
  frame::Renderer renderer;  // keeps the structures of meshes from picture to picture
  for (int picture = request.firstPicture; picture < request.pictures; ++picture) {
    if (request.cameras)
      options.camera = cameraOf(request.cameras[picture]);
    else
      options.turn = 360.0 * picture / request.pictures;
    options.overlays = options.overlays && request.pictures == 1 && !request.cameras;
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
