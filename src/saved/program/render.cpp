#include "saved/program/render.h"

#include "saved/exr/exr_writer.h"
#include "saved/layers/picture_layers.h"
#include "saved/program/camera_of.h"
#include "saved/scene/scene_hash.h"
#include "saved/shot/linear_color.h"
#include "saved/shot/picture_settings.h"
#include "saved/shot/shot.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

namespace gluray::saved {
namespace {

Fit fitOf(const std::string& word) {
  if (word == "all") return Fit::all;
  if (word == "crop") return Fit::crop;
  if (word == "stretch") return Fit::stretch;
  throw std::runtime_error("fit: use all, crop or stretch");
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

constexpr size_t kBandFloats = size_t{1} << 25;  // of a band with layers

/// A picture, and what the request wants of it.
class Picture {
 public:
  Picture(const SavedScene& scene, const ShotOptions& options, frame::Renderer& renderer,
          const GlurayRenderRequest& request)
      : shot(scene, withRoom(options, request), renderer),
        layers(shot, renderer, wanted(request)),
        values_(request.values) {}

  size_t floats() const { return kColors + layers.channels(); }
  /// What an OpenEXR file has.
  std::string header() const {
    nlohmann::json channels = nlohmann::json::array(), texts = nlohmann::json::object();
    for (const char* name : {"R", "G", "B", "A"}) channels.push_back({{"name", name}, {"color", true}});
    for (const Layer layer : layers.layers())
      for (const std::string& name : channelsOf(layer))
        channels.push_back({{"name", name}, {"color", isColor(layer)}});
    for (const auto& [name, text] : layers.texts()) texts[name] = text;
    return nlohmann::json{{"channels", channels}, {"texts", texts}}.dump();
  }
  /// Whether the sink goes on.
  bool give(int band, const GlurayRenderSink& sink) {
    if (values_ == kGlurayBytes) return give(band, shot.band(band), 1, sink);
    if (values_ == kGlurayDisplayed) return give(band, shot.wideBand(band, Shot::Range::limited), 1, sink);
    const std::vector<glm::vec4> colors = shot.wideBand(band, Shot::Range::open);
    std::vector<float> floats(colors.size() * this->floats());
    for (size_t i = 0; i < colors.size(); ++i) {
      const glm::vec4 light = lightOf(colors[i]);
      std::copy_n(&light.x, kColors, &floats[i * this->floats()]);
    }
    layers.write(band, floats.data() + kColors, this->floats());
    return give(band, floats, this->floats(), sink);
  }

  Shot shot;
  PictureLayers layers;

 private:
  static constexpr size_t kColors = 4;
  static std::vector<Layer> wanted(const GlurayRenderRequest& request) {
    return layersIn(request.values == kGlurayLinear ? request.layers : "");
  }
  /// Smaller bands where pixels have many values.
  static ShotOptions withRoom(ShotOptions options, const GlurayRenderRequest& request) {
    size_t floats = kColors;
    for (const Layer layer : wanted(request)) floats += channelsOf(layer).size();
    if (floats > kColors)
      options.bandPixels = std::min(options.bandPixels, static_cast<int>(kBandFloats / floats));
    return options;
  }
  template <class Value>
  bool give(int band, const std::vector<Value>& pixels, size_t each, const GlurayRenderSink& sink) const {
    const size_t rows = pixels.size() / each / static_cast<size_t>(shot.size().x);
    return sink.rows(sink.user, band, static_cast<int>(rows), pixels.data()) != 0;
  }

  int values_;
};

/// One picture. False: the sink has ended it.
bool renderOne(Picture& picture, int number, int firstBand, const std::string& facts,
               const GlurayRenderSink& sink) {
  Shot& shot = picture.shot;
  if (!sink.begin(sink.user, number, shot.size().x, shot.size().y, shot.bandRows(), facts.c_str()))
    return false;
  for (const auto& notes : {shot.notes(), picture.layers.notes()})
    for (const std::string& line : notes) sink.note(sink.user, line.c_str());
  for (int band = firstBand; band < shot.bands(); ++band)
    if (!picture.give(band, sink)) return false;
  return sink.end(sink.user) != 0;
}

bool render(const GlurayRenderRequest& request, const GlurayRenderSink& sink) {
  if (request.version != kGlurayRenderVersion)
    throw std::runtime_error("install GLuRay again: its library is of another version");
  SavedScene scene = readScene(request.scene);
  const std::vector<std::string> settings(request.settings, request.settings + request.settingCount);
  const std::string facts = factsOf(scene, request.sceneHash);
  ShotOptions options{.size = {request.width, request.height},
                      .fit = fitOf(request.fit),
                      .transparent = request.transparent != 0,
                      .overlays = request.overlays != 0,
                      .known = knownViewOf(scene, request),
                      .settings = withValues(settings),
                      .edgeSamples = edgeSamplesFor(settings)};
  if (request.values == kGlurayLinear && !canWriteExr())
    throw std::runtime_error("this GLuRay was built without OpenEXR: use a name that ends in .png");
  frame::Renderer renderer;  // keeps the structures of meshes from picture to picture
  for (int picture = request.firstPicture; picture < request.pictures; ++picture) {
    if (request.cameras)
      options.camera = cameraOf(request.cameras[picture]);
    else
      options.turn = 360.0 * picture / request.pictures;
    options.overlays = options.overlays && request.pictures == 1 && !request.cameras;
    Picture made(scene, options, renderer, request);
    const bool first = picture == request.firstPicture;
    if (first && request.values == kGlurayLinear &&
        !sink.channels(sink.user, static_cast<int>(made.floats()), made.header().c_str()))
      return false;
    if (!renderOne(made, picture, first ? request.firstBand : 0, facts, sink)) return false;
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
