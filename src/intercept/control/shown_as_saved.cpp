#include "intercept/control/shown_as_saved.h"

#include "cluster/messages/version.h"
#include "intercept/control/engine_program.h"

#include <array>
#include <ctime>

namespace gluray::intercept {
namespace {

std::string timeNow() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  std::array<char, 32> text{};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts)};
}

}  // namespace

saved::SavedScene savedScene(const gl::ShownFrame& frame, const ShownWindowPlaces& window) {
  const std::vector<ShownView> views = viewsOf(frame);
  saved::SavedScene scene;
  scene.window = window.size == glm::ivec2(0) ? extentOf(views) : window.size;
  scene.facts = {{"program", programName()}, {"version", cluster::version()}, {"saved", timeNow()}};
  for (const gl::ShownBatch& batch : frame.batches) {
    saved::SavedBatch& one = scene.batches.emplace_back();
    one.snapshot = batch.snapshot, one.strict = batch.strict;
    one.place = placeOf(views, batch.framebuffer, window).value_or(glm::ivec2(0));
    for (const gl::ClearedDepth& clear : batch.cleared)
      if (clear.framebuffer == batch.framebuffer) one.cleared.push_back(clear.box);
  }
  return scene;
}

}  // namespace gluray::intercept
