#include "gl/views/view_scenes.h"

#include "base/log.h"
#include "gl/batch/clears.h"
#include "gl/views/expected_surfaces.h"
#include "gl/views/secondary_scene_builder.h"
#include "gl/views/view_changes.h"
#include "scene/same_camera.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <utility>

namespace gluray::gl {
namespace {

constexpr size_t kMaxBatches = 256;      // of an epoch that no clear ends
constexpr size_t kMaxSimilarEpochs = 4;  // ended epochs of one viewport: layers of renderers
constexpr uint64_t kLongAgo = 256;       // ends

/// Passes that draw layers write into textures of their own, which are as large as the view.
bool drawsAside(const BatchKey& key) {
  return key.layers == BatchKey::Layers::peeled || key.layers == BatchKey::Layers::summed;
}

bool isAt(const ViewEpoch& epoch, GLuint framebuffer, GLenum drawBuffer, const glm::ivec4& viewport) {
  return epoch.framebuffer == framebuffer && epoch.drawBuffer == drawBuffer && epoch.viewport == viewport;
}

bool holds(const ViewEpoch& epoch, const BatchKey& key, const scene::Snapshot& s) {
  const glm::ivec4 &a = epoch.viewport, &b = key.viewport;
  if (!isAt(epoch, key.framebuffer, key.drawBuffer, key.viewport) &&
      !(drawsAside(key) && a.z == b.z && a.w == b.w))
    return false;
  return eyeFromEye(s, epoch.first()).has_value();
}

}  // namespace

ViewEpoch* ViewScenes::epochOf(const BatchKey& key, const scene::Snapshot& s) {
  const auto found =
      std::find_if(open_.rbegin(), open_.rend(), [&](const ViewEpoch& e) { return holds(e, key, s); });
  return found == open_.rend() ? nullptr : &*found;
}

/// The ended epoch that a view repeats which begins with this batch.
ViewScenes::Ended::iterator ViewScenes::lastOf(const BatchKey& key, const scene::Snapshot& s) {
  auto found = ended_.end();
  Likeness best = Likeness::none;
  for (auto it = ended_.begin(); it != ended_.end(); ++it) {
    if (!isAt(**it, key.framebuffer, key.drawBuffer, key.viewport)) continue;
    const Likeness likeness = likenessOf((*it)->first(), s);
    if (likeness != Likeness::none && likeness >= best) best = likeness, found = it;
  }
  return found;
}

std::shared_ptr<const scene::SecondaryScene> ViewScenes::secondaryScene(const BatchKey& key,
                                                                        const scene::Snapshot& s,
                                                                        bool isLast) noexcept {
  forgetUnwanted(s.settings);
  if (!scene::needsSecondaryScene(s.settings)) return nullptr;
  try {
    const ViewEpoch* epoch = epochOf(key, s);
    const ViewEpoch* last = epoch ? epoch->last.get() : nullptr;
    if (isLast) last = nullptr;
    if (!epoch && !drawsAside(key) && !isLast)
      if (const auto found = lastOf(key, s); found != ended_.end()) last = found->get();
    if (!epoch && !last) return nullptr;
    SecondarySceneBuilder maker(s);
    const scene::Snapshot& first = epoch ? epoch->first() : s;
    if (epoch)
      for (const ViewEpoch::Drawn& earlier : epoch->batches)
        if (const auto eyeFromPart = eyeFromEye(s, *earlier.snapshot))
          maker.add(*earlier.snapshot, *eyeFromPart, earlier.capture, earlier.erased);
    if (last) {
      const Repetition now = repetitionOf(*last, epoch ? epoch->repeated : 0, s);
      addLater(*last, now, movementOf(*last, epoch, now, s), first, s, maker);
    }
    const glm::dmat4 eyeFromView = *eyeFromEye(s, first) * first.eyeFromWorld;
    return maker.takeSecondaryScene(
        eyeFromView == s.eyeFromWorld ? glm::dmat4(1) : glm::inverse(eyeFromView) * s.eyeFromWorld);
  } catch (const std::exception&) {
    forget();
    log::once(log::Level::warning, "views",
              "out of memory: light effects act only between surfaces that are drawn together");
    return nullptr;
  }
}

float ViewScenes::extentOf(const scene::Snapshot& s) const noexcept {
  try {
    return scene::needsSecondaryScene(s.settings) ? extents_.extentOf(s) : 0;
  } catch (const std::exception&) { return 0; }  // out of memory
}

void ViewScenes::forgetUnwanted(const Settings& settings) {
  if (!scene::needsSecondaryScene(settings)) open_.clear(), ended_.clear(), extents_.clear();
  if (!wantsShownViews(settings)) shown_.clear();
}

std::optional<ShownViews::Clear> ViewScenes::paintsOver(const BatchKey& key,
                                                        const scene::Snapshot& s) const noexcept {
  const bool seen = key.layers == BatchKey::Layers::none && key.colorWrites.all();
  if (!scene::wantsBackdrop(s.settings) || !seen || !holdsLitSurface(s)) return std::nullopt;
  return shown_.mayPaint(key, s.region, s.frame);
}

void ViewScenes::colorCleared(const ShownViews::Clear& clear) noexcept {
  frames_.cleared(clear.framebuffer, clear.box);
  try {
    shown_.colorCleared(clear);
  } catch (const std::exception&) { forget(); }
}

uint64_t ViewScenes::frameOf(const BatchKey& key, const scene::Snapshot& s) noexcept {
  if (!scene::needsSecondaryScene(s.settings)) return 0;
  try {
    return frames_.traced(key.framebuffer, s.region);
  } catch (const std::exception&) { return 0; }  // no memory
}

LightsUp ViewScenes::upwardAxisOf(const BatchKey& key, const scene::Snapshot& s) noexcept {
  if (s.settings.lights.up != LightsUp::automatic) return s.settings.lights.up;
  if (!scene::changesLight(s.settings) && !scene::wantsGround(s.settings)) return LightsUp::automatic;
  try {
    return axes_.axisOf(key, s);
  } catch (const std::exception&) { return LightsUp::automatic; }  // no memory
}

scene::GroundUse ViewScenes::groundOf(const BatchKey& key, const scene::Snapshot& s) noexcept {
  using scene::GroundUse;
  if (!scene::wantsGround(s.settings)) return GroundUse::none;
  if (const ViewEpoch* epoch = epochOf(key, s))
    for (const ViewEpoch::Drawn& drawn : epoch->batches)
      if (drawn.snapshot->ground == GroundUse::drawn) return GroundUse::around;
  const scene::ColorWrites& writes = key.colorWrites;
  const bool seen = key.layers == BatchKey::Layers::none && (writes.red || writes.green || writes.blue);
  return seen && holdsLitSurface(s) && shown_.mayStand(key, s.frame) ? GroundUse::drawn : GroundUse::none;
}

void ViewScenes::traced(const BatchKey& key, const scene::SnapshotPtr& snapshot,
                        const std::shared_ptr<const scene::FramebufferCapture>& capture) noexcept {
  try {
    if (wantsShownViews(snapshot->settings)) shown_.traced(key, *snapshot);
    if (!scene::needsSecondaryScene(snapshot->settings)) return;
    ViewEpoch* epoch = epochOf(key, *snapshot);
    // Nothing tells when such an epoch would end.
    if (!epoch && drawsAside(key)) return;
    if (!epoch) {
      ViewEpoch fresh{key.framebuffer, key.drawBuffer, key.viewport, snapshot->region, {}};
      if (const auto found = lastOf(key, *snapshot); found != ended_.end())
        fresh.last = *found, ended_.erase(found);
      epoch = &open_.emplace_back(std::move(fresh));
    }
    ViewEpoch::Drawn drawn{snapshot, false, capture, nullptr};
    if (epoch->last) {
      const Repetition now = repetitionOf(*epoch->last, epoch->repeated, *snapshot);
      drawn.still = now.of && isStill(*now.of->snapshot, *snapshot);
      if (epoch->batches.empty()) epoch->moves = now.of && !drawn.still;
      epoch->repeated = now.repeated;
    }
    if (epoch->batches.size() >= kMaxBatches) epoch->batches.erase(epoch->batches.begin());
    epoch->batches.push_back(std::move(drawn));
    epoch->isChecked = false;
    if (!drawsAside(key)) epoch->region = scene::united(epoch->region, snapshot->region);
  } catch (const std::exception&) { forget(); }
}

void ViewScenes::wrote(const scene::SnapshotPtr& snapshot, std::shared_ptr<const Image> written) noexcept {
  for (auto epoch = open_.rbegin(); epoch != open_.rend(); ++epoch)
    for (ViewEpoch::Drawn& drawn : epoch->batches)
      if (drawn.snapshot == snapshot) return void(drawn.written = std::move(written));
}

std::vector<GLuint> ViewScenes::unchecked() const {
  std::vector<GLuint> found;
  for (const ViewEpoch& epoch : open_)
    if (!epoch.isChecked && std::find(found.begin(), found.end(), epoch.framebuffer) == found.end())
      found.push_back(epoch.framebuffer);
  return found;
}

std::vector<ViewScenes::Outdated> ViewScenes::outdated(GLuint framebuffer) noexcept {
  std::vector<Outdated> found;
  try {
    for (ViewEpoch& epoch : open_) {
      if (epoch.framebuffer != framebuffer || std::exchange(epoch.isChecked, true)) continue;
      for (size_t i = 0; i < epoch.batches.size(); ++i) {
        ViewEpoch::Drawn& drawn = epoch.batches[i];
        if (!drawn.written) continue;
        const scene::SnapshotPtr now = relitOf(epoch, i, extents_);
        const bool isOver = !found.empty() && now->layers && now->layers->of == scene::Layers::Of::drawn;
        if (now != drawn.snapshot || isOver)
          found.push_back({epoch.drawBuffer, drawn.snapshot, now, drawn.written, epoch.writtenAfter(i)});
      }
    }
  } catch (const std::exception&) { forget(); }
  return found;
}

void ViewScenes::relit(const Outdated& batch, std::shared_ptr<const Image> written) noexcept {
  for (ViewEpoch& epoch : open_)
    for (ViewEpoch::Drawn& drawn : epoch.batches) {
      if (drawn.snapshot != batch.before) continue;
      drawn.relight(batch.now);
      return void(drawn.written = std::move(written));
    }
}

scene::SnapshotPtr ViewScenes::broughtUpToDate(const scene::SnapshotPtr& snapshot) noexcept {
  try {
    for (ViewEpoch& epoch : open_)
      for (size_t i = 0; i < epoch.batches.size(); ++i)
        if (epoch.batches[i].snapshot == snapshot) {
          epoch.batches[i].relight(relitOf(epoch, i, extents_));
          return epoch.batches[i].snapshot;
        }
  } catch (const std::exception&) { forget(); }
  return snapshot;
}

template <class Is>
void ViewScenes::withdrawIf(const Is& is) noexcept {
  for (ViewEpoch& epoch : open_)
    if (std::erase_if(epoch.batches, is) > 0) epoch.isChecked = false;
  std::erase_if(open_, [](const ViewEpoch& epoch) { return epoch.batches.empty(); });
}

void ViewScenes::withdraw(const scene::SnapshotPtr& snapshot) noexcept {
  withdrawIf([&](const ViewEpoch::Drawn& drawn) { return drawn.snapshot == snapshot; });
}

void ViewScenes::withdrawPeeled(uint64_t frame) noexcept {
  const auto isPeeled = [&](const ViewEpoch::Drawn& drawn) {
    const scene::Snapshot& s = *drawn.snapshot;
    return s.frame == frame && s.layers && s.layers->of == scene::Layers::Of::order;
  };
  withdrawIf(isPeeled);
}

template <class Ends>
void ViewScenes::end(const Ends& ends) noexcept {
  const auto first =
      std::stable_partition(open_.begin(), open_.end(), [&](const auto& e) { return !ends(e); });
  if (first == open_.end()) return;
  ++clock_;
  try {
    for (auto epoch = first; epoch != open_.end(); ++epoch) {
      extents_.remember(*epoch);
      if (epoch->batches.size() < 2) continue;  // nothing comes later
      epoch->last.reset();
      for (ViewEpoch::Drawn& drawn : epoch->batches) drawn.written.reset();
      epoch->ended = clock_;
      ended_.push_back(std::make_shared<const ViewEpoch>(std::move(*epoch)));
    }
    open_.erase(first, open_.end());
    forgetOld();
  } catch (const std::exception&) { forget(); }
}

void ViewScenes::forgetOld() {
  Ended kept;
  for (auto it = ended_.rbegin(); it != ended_.rend(); ++it) {
    const ViewEpoch& e = **it;
    const auto alike = std::count_if(kept.begin(), kept.end(), [&](const auto& k) {
      return isAt(*k, e.framebuffer, e.drawBuffer, e.viewport);
    });
    // Volumes are large: none but the last ones are held.
    const size_t most = e.holdsVolumes() ? 1 : kMaxSimilarEpochs;
    if (clock_ - e.ended < kLongAgo && static_cast<size_t>(alike) < most) kept.push_back(*it);
  }
  ended_.assign(kept.rbegin(), kept.rend());
}

void ViewScenes::depthCleared(GLuint framebuffer, const scene::Region& box) noexcept {
  end([&](const ViewEpoch& epoch) {
    return epoch.framebuffer == framebuffer && contains(box, epoch.region);
  });
  try {
    for (ViewEpoch& epoch : open_)
      if (epoch.framebuffer == framebuffer) eraseSurfaces(epoch, box);
  } catch (const std::exception&) { forget(); }
}

void ViewScenes::swapped() noexcept {
  end([](const ViewEpoch& epoch) { return epoch.framebuffer == 0; });
}

}  // namespace gluray::gl
