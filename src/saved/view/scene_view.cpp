#include "saved/view/scene_view.h"

#include "frame/questions/pick.h"
#include "saved/shot/moved_view.h"
#include "saved/shot/picture_settings.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace gluray::saved {
namespace {

using Images = std::function<const Image&(const scene::Snapshot&)>;

std::vector<scene::SnapshotPtr> snapshotsOf(const SavedScene& scene) {
  std::vector<scene::SnapshotPtr> snapshots;
  for (const SavedBatch& batch : scene.batches) snapshots.push_back(batch.snapshot);
  return snapshots;
}

/// Passes of the next step: it pays to show the first ones one by one.
uint32_t after(uint32_t passes) { return passes + std::max(1u, passes / 4); }

}  // namespace

/// What pictures with the same settings have in common.
struct SceneView::Look {
  std::vector<std::string> settings;
  uint64_t number;
  GrowingImages window;  // the window with these settings
  std::shared_ptr<WindowMemory> rough = std::make_shared<WindowMemory>(),
                                exact = std::make_shared<WindowMemory>();
  bool isExact = false;  // the window's images are finished
};

SceneView::SceneView(SavedScene scene)
    : scene_(std::move(scene)),
      camera_(derivedCamera(snapshotsOf(scene_))),
      program_([this](const auto& s, Image& image, auto& cost, std::string& error) {
        return renderer_.renderBehind(s, image, cost, error, stop_);
      }) {}

SceneView::~SceneView() = default;

void SceneView::takeLook(const std::vector<std::string>& settings) {
  if (look_ && look_->settings == settings) return;
  look_ = std::make_unique<Look>(Look{
      settings, ++looks_, GrowingImages([this](const auto& s, Image& image, auto& cost, std::string& error) {
        return renderer_.renderBehind(s, image, cost, error, stop_);
      })});
}

ShotOptions SceneView::optionsFor(const ViewRequest& request) const {
  if (request.camera && !camera_) throw std::runtime_error("the camera of this view is not known");
  return {.size = request.size,
          .fit = Fit::all,
          .overlays = !request.camera,
          .camera = request.camera,
          .known = request.camera ? std::make_shared<KnownView>(camera_->known) : nullptr,
          .settings = withValues(request.settings),
          .edgeSamples = edgeSamplesFor(request.settings),
          .look = look_->number};
}

/// `exact`: what it needs to know of the window is finished; otherwise it has one pass. `images`: those of
/// the picture's bands.
std::unique_ptr<Shot> SceneView::shotOf(ShotOptions options, bool exact, const Images& images) {
  const uint32_t passes = exact ? GrowingImages::kAll : 1;
  program_.compose(passes), look_->window.compose(passes);
  options.window = exact ? look_->exact : look_->rough;
  auto inWindow = std::make_shared<bool>(true);
  options.images = [this, images, inWindow](const scene::Snapshot& s) -> const Image& {
    if (!*inWindow) return images(s);
    return (Shot::isOfProgram(s) ? program_ : look_->window).imageOf(s);
  };
  auto shot = std::make_unique<Shot>(scene_, options, renderer_);
  *inWindow = false;
  look_->isExact |= exact;
  return shot;
}

void SceneView::showMoving(const ViewRequest& request, const Take& take) {
  stop_ = [] { return false; };
  takeLook(request.settings);
  ShotOptions options = optionsFor(request);
  options.edgeSamples = 1;
  const auto shot = shotOf(options, look_->isExact, [this](const scene::Snapshot& s) -> const Image& {
    scene::Snapshot moving = s;
    moving.lightSampling = {.mode = scene::LightSampling::Mode::moving, .aliased = true};
    scene::TraceCost cost;
    std::string error;
    moving_.missColor = 0;
    if (!renderer_.render(moving, moving_, cost, error))
      throw std::runtime_error("it cannot be traced: " + error);
    return moving_;
  });
  std::vector<uint32_t> pixels;
  for (int band = 0; band < shot->bands(); ++band) {
    const std::vector<uint32_t> rows = shot->band(band);
    pixels.insert(pixels.end(), rows.begin(), rows.end());
  }
  take({.size = request.size}, pixels);
}

bool SceneView::show(const ViewRequest& request, const Stop& stop, const Take& take) try {
  stop_ = stop;
  takeLook(request.settings);
  std::vector<GrowingImages> bands;
  size_t band = 0;
  const Images images = [&](const scene::Snapshot& s) -> const Image& { return bands[band].imageOf(s); };
  std::unique_ptr<Shot> shot = shotOf(optionsFor(request), look_->isExact, images);
  for (int i = 0; i < shot->bands(); ++i)
    bands.emplace_back([this](const auto& s, Image& image, auto& cost, std::string& error) {
      return renderer_.renderBehind(s, image, cost, error, stop_);
    });
  const auto compose = [&](uint32_t passes, bool last) {
    std::vector<uint32_t> pixels;
    ViewStep step{.size = request.size, .finished = true};
    for (band = 0; band < bands.size(); ++band) {
      bands[band].compose(passes);
      const std::vector<uint32_t> rows = shot->band(static_cast<int>(band));
      pixels.insert(pixels.end(), rows.begin(), rows.end());
      step.passes = std::max(step.passes, bands[band].passes());
      step.noise = std::max(step.noise, bands[band].noise());
      step.finished &= bands[band].finished();
    }
    const bool done = step.finished;
    step.finished &= last;
    take(step, pixels);
    return done;
  };
  const bool exact = look_->isExact;
  for (uint32_t passes = 1; !compose(passes, exact); passes = after(passes))
    if (stop()) return false;
  if (exact) return true;
  shot = shotOf(optionsFor(request), true, images);
  return compose(GrowingImages::kAll, true);
} catch (const Stopped&) { return false; }

std::optional<glm::dvec3> SceneView::pointAt(const ViewRequest& request, const glm::ivec2& pixel) {
  if (!camera_) return std::nullopt;
  stop_ = [] { return false; };
  takeLook(request.settings);
  const auto shot = shotOf(optionsFor(request), look_->isExact, {});
  const KnownView& known = camera_->known;
  const glm::dmat4 knownFromWorld =
      request.camera ? eyeFromWorld(known, *request.camera) : known.eyeFromWorld;
  std::optional<glm::dvec3> nearest;
  double least = 0;
  const ViewCamera& camera = request.camera ? *request.camera : known.camera;
  for (const Shot::Placed& placed : shot->placed()) {
    glm::dmat4 ownFromKnown(1);
    if (placed.snapshot.layers || !sharesView(*placed.saved, *known.batch, ownFromKnown)) continue;
    const auto picked =
        frame::pick(renderer_, placed.snapshot, {pixel.x + 0.5, request.size.y - pixel.y - 0.5});
    if (!picked) continue;
    const glm::dvec3 point(glm::inverse(ownFromKnown * knownFromWorld) * glm::dvec4(picked->point, 1));
    const double distance = glm::dot(point - camera.position, camera.focalPoint - camera.position);
    if (!nearest || distance < least) nearest = point, least = distance;
  }
  return nearest;
}

}  // namespace gluray::saved
