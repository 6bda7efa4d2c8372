#include "gl/batch/view_scenes.h"

#include "base/log.h"
#include "gl/batch/same_camera.h"
#include "gl/batch/surroundings_maker.h"
#include "gl/window/clears.h"

#include <algorithm>
#include <cmath>
#include <exception>

namespace gluray::gl {
namespace {

constexpr size_t kMostBatches = 256;  // of an epoch that no clear ends

scene::Region united(const scene::Region& a, const scene::Region& b) {
  const int x = std::min(a.x, b.x), y = std::min(a.y, b.y);
  return {x, y, std::max(a.x + a.width, b.x + b.width) - x, std::max(a.y + a.height, b.y + b.height) - y};
}

/// A length that tells how far from the eye a snapshot's surfaces are.
double distanceOf(const scene::Snapshot& s) { return glm::length(glm::dvec3(s.eyeFromWorld[3])); }

std::optional<glm::dmat4> eyeFromEye(const scene::Snapshot& to, const scene::Snapshot& from) {
  return gl::eyeFromEye(to.camera.clipFromEye, from.camera.clipFromEye,
                        std::max(distanceOf(to), distanceOf(from)));
}

/// Passes that draw layers write into textures of their own, which are as large as the view.
bool drawsAside(const BatchKey& key) {
  return key.layers == BatchKey::Layers::peeled || key.layers == BatchKey::Layers::summed;
}

}  // namespace

bool ViewScenes::holds(const Epoch& epoch, const BatchKey& key, const scene::Snapshot& s) const {
  const bool same = epoch.framebuffer == key.framebuffer && epoch.drawBuffer == key.drawBuffer &&
                    epoch.viewport == key.viewport;
  const glm::ivec4 &a = epoch.viewport, &b = key.viewport;
  if (!same && !(drawsAside(key) && a.z == b.z && a.w == b.w)) return false;
  return eyeFromEye(s, *epoch.batches.front()).has_value();
}

ViewScenes::Epoch* ViewScenes::epochOf(const BatchKey& key, const scene::Snapshot& s) {
  const auto found =
      std::find_if(open_.rbegin(), open_.rend(), [&](const Epoch& e) { return holds(e, key, s); });
  return found == open_.rend() ? nullptr : &*found;
}

std::shared_ptr<const scene::Surroundings> ViewScenes::around(const BatchKey& key,
                                                              const scene::Snapshot& s) noexcept {
  if (!scene::needsSurroundings(s.settings)) {
    if (!empty()) forget();
    return nullptr;
  }
  try {
    const Epoch* epoch = epochOf(key, s);
    if (!epoch) return nullptr;
    SurroundingsMaker maker(s);
    for (const scene::SnapshotPtr& earlier : epoch->batches)
      if (const auto eyeFromPart = eyeFromEye(s, *earlier)) maker.add(*earlier, *eyeFromPart);
    const scene::Snapshot& first = *epoch->batches.front();
    const glm::dmat4 eyeFromView = *eyeFromEye(s, first) * first.eyeFromWorld;
    return maker.take(eyeFromView == s.eyeFromWorld ? glm::dmat4(1)
                                                    : glm::inverse(eyeFromView) * s.eyeFromWorld);
  } catch (const std::exception&) {
    forget();
    log::once(log::Level::warning, "views",
              "memory has run out: surfaces light only those that are drawn with them");
    return nullptr;
  }
}

void ViewScenes::traced(const BatchKey& key, const scene::SnapshotPtr& snapshot) noexcept {
  if (!scene::needsSurroundings(snapshot->settings)) return;
  try {
    Epoch* epoch = epochOf(key, *snapshot);
    // Nothing tells when such an epoch would end.
    if (!epoch && drawsAside(key)) return;
    if (!epoch)
      epoch = &open_.emplace_back(Epoch{key.framebuffer, key.drawBuffer, key.viewport, snapshot->region, {}});
    if (epoch->batches.size() >= kMostBatches) epoch->batches.erase(epoch->batches.begin());
    epoch->batches.push_back(snapshot);
    if (!drawsAside(key)) epoch->drawn = united(epoch->drawn, snapshot->region);
  } catch (const std::exception&) { forget(); }
}

void ViewScenes::depthCleared(GLuint framebuffer, const scene::Region& box) {
  std::erase_if(open_, [&](const Epoch& epoch) {
    return epoch.framebuffer == framebuffer && contains(box, epoch.drawn);
  });
}

void ViewScenes::swapped() {
  std::erase_if(open_, [](const Epoch& epoch) { return epoch.framebuffer == 0; });
}

}  // namespace gluray::gl
