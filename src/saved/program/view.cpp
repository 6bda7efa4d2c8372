#include "saved/program/view.h"

#include "saved/program/camera_of.h"
#include "saved/view/scene_view.h"
#include "settings/values.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

struct GlurayView {
  explicit GlurayView(gluray::saved::SavedScene scene) : view(std::move(scene)) {}
  gluray::saved::SceneView view;
  std::string settings;
};

namespace gluray::saved {
namespace {

ViewRequest requestOf(const GlurayViewRequest& from) {
  ViewRequest request{.size = {from.width, from.height}};
  if (from.camera) request.camera = cameraOf(*from.camera);
  request.settings.assign(from.settings, from.settings + from.settingCount);
  return request;
}

GlurayViewFacts factsOf(const SceneView& view) {
  const SavedScene& scene = view.scene();
  const bool knows = scene.shown.width == scene.window.x && scene.shown.height == scene.window.y;
  GlurayViewFacts facts{};
  facts.width = scene.window.x, facts.height = scene.window.y;
  facts.shown = knows ? scene.shown.pixels.data() : nullptr;
  facts.movable = view.camera().has_value();
  if (!facts.movable) return facts;
  facts.camera = cameraOf(view.camera()->camera);
  std::copy_n(&view.camera()->middle.x, 3, facts.middle);
  facts.radius = view.camera()->radius;
  return facts;
}

/// Those of the view with the most pixels: others are orientation markers and the like. JSON.
std::string settingsOf(const SavedScene& scene) {
  Session session;
  int64_t most = -1;
  for (const SavedBatch& batch : scene.batches) {
    const glm::ivec4 viewport = batch.snapshot->camera.viewport;
    const int64_t pixels = int64_t{viewport.z} * viewport.w;
    if (pixels > most) most = pixels, session.settings = batch.snapshot->settings;
  }
  nlohmann::json texts = nlohmann::json::object();
  for (const Row& row : settingRows()) texts[std::string(row.name)] = printValue(row, session);
  return texts.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

/// The result of `work`, or none with one line in `why`.
template <class Result, class Work>
Result guarded(char* why, unsigned long whyBytes, Result none, const Work& work) {
  std::snprintf(why, whyBytes, "%s", "");
  try {
    return work();
  } catch (const std::exception& e) {
    std::snprintf(why, whyBytes, "%s", e.what());
    return none;
  }
}

}  // namespace
}  // namespace gluray::saved

using namespace gluray::saved;

__attribute__((visibility("default"))) GlurayView* glurayViewOpen(int version, const char* scene,
                                                                  GlurayViewFacts* facts, char* why,
                                                                  unsigned long whyBytes) {
  return guarded<GlurayView*>(why, whyBytes, nullptr, [&] {
    if (version != kGlurayRenderVersion)
      throw std::runtime_error("install GLuRay again: its library is of another version");
    auto view = std::make_unique<GlurayView>(readScene(scene));
    if (view->view.scene().window.x < 1 || view->view.scene().window.y < 1)
      throw std::runtime_error("the size of the window is not known");
    view->settings = settingsOf(view->view.scene());
    *facts = factsOf(view->view), facts->settings = view->settings.c_str();
    return view.release();
  });
}

__attribute__((visibility("default"))) void glurayViewClose(GlurayView* view) { delete view; }

__attribute__((visibility("default"))) int glurayViewShow(GlurayView* view, const GlurayViewRequest* request,
                                                          const GlurayViewSink* sink, char* why,
                                                          unsigned long whyBytes) {
  return guarded(why, whyBytes, 0, [&] {
    const SceneView::Take take = [&](const ViewStep& step, const std::vector<uint32_t>& pixels) {
      sink->take(sink->user, step.size.x, step.size.y, pixels.data(), step.passes, step.noise, step.finished);
    };
    if (!request->moving)
      return view->view.show(
                 requestOf(*request), [&] { return sink->stop(sink->user) != 0; }, take)
                 ? 1
                 : 0;
    view->view.showMoving(requestOf(*request), take);
    return 1;
  });
}

__attribute__((visibility("default"))) int glurayViewPoint(GlurayView* view, const GlurayViewRequest* request,
                                                           int x, int y, double point[3]) {
  char why[1];
  return guarded(why, sizeof why, 0, [&] {
    const auto found = view->view.pointAt(requestOf(*request), {x, y});
    if (found) std::copy_n(&found->x, 3, point);
    return found ? 1 : 0;
  });
}
