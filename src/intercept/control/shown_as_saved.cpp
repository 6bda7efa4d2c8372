#include "intercept/control/shown_as_saved.h"

#include "cluster/messages/version.h"
#include "intercept/session/session.h"

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

/// The part of the window that shows the views: that of the framebuffer objects that they are drawn into, if
/// they all have one place, otherwise all of it.
std::optional<glm::ivec4> boxOf(const gl::ShownFrame& frame, const std::vector<ShownView>& views,
                                const ShownWindowPlaces& window) {
  const glm::ivec2 all = window.size == glm::ivec2(0) ? extentOf(views) : window.size;
  std::optional<glm::ivec4> box;
  for (const gl::ShownBatch& batch : frame.batches) {
    if (batch.framebuffer == 0) return glm::ivec4(0, 0, all);
    const auto place = placeOf(views, batch.framebuffer, window);
    if (!place) return std::nullopt;
    const glm::ivec4 one(*place, extentOf(views, batch.framebuffer));
    if (box && *box != one) return glm::ivec4(0, 0, all);
    box = one;
  }
  return box;
}

}  // namespace

ShownAsSaved shownAsSaved(const gl::ShownFrame& frame, const ShownWindowPlaces& window) {
  const std::vector<ShownView> views = viewsOf(frame);
  ShownAsSaved shown{.box = boxOf(frame, views, window)};
  saved::SavedScene& scene = shown.scene;
  scene.window = shown.box ? glm::ivec2(shown.box->z, shown.box->w) : extentOf(views);
  scene.facts = {{"program", programName()}, {"version", cluster::version()}, {"saved", timeNow()}};
  for (const gl::ShownBatch& batch : frame.batches) {
    saved::SavedBatch& one = scene.batches.emplace_back();
    one.snapshot = batch.snapshot, one.strict = batch.strict;
    if (shown.box)
      one.place = placeOf(views, batch.framebuffer, window).value_or(glm::ivec2(0)) - glm::ivec2(*shown.box);
    for (const gl::ClearedDepth& clear : batch.cleared)
      if (clear.framebuffer == batch.framebuffer) one.cleared.push_back(clear.box);
  }
  return shown;
}

}  // namespace gluray::intercept
