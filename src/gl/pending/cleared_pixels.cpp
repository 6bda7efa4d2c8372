#include "gl/pending/cleared_pixels.h"

#include "base/log.h"
#include "gl/batch/clears.h"
#include "gl/pending/pending_batch.h"
#include "gl/real/errors.h"

#include <algorithm>
#include <cmath>
#include <exception>

namespace gluray::gl {
namespace {

/// Whether two bytes stand for one value: OpenGLs differ in how they round.
bool isNear(uint32_t a, uint32_t b) { return a > b ? a - b <= 1 : b - a <= 1; }

bool isNear(uint32_t a, uint32_t b, int bits) {
  for (int shift = 0; shift < bits; shift += 8)
    if (!isNear(a >> shift & 255, b >> shift & 255)) return false;
  return true;
}

}  // namespace

std::optional<scene::Backdrop> backdropWhere(const std::vector<uint32_t>& colors,
                                             const glm::vec4& clearColor) {
  uint32_t cleared = 0;
  for (int c = 0; c < 4; ++c)
    cleared |= static_cast<uint32_t>(std::lrint(std::clamp(clearColor[c], 0.0f, 1.0f) * 255)) << (8 * c);
  const bool alpha =
      std::any_of(colors.begin(), colors.end(), [](uint32_t color) { return color >> 24 != 255; });
  size_t count = 0;
  scene::Backdrop backdrop;
  backdrop.isClear.reserve(colors.size());
  for (const uint32_t color : colors) {
    const bool clear = isNear(color, cleared, alpha ? 32 : 24);
    backdrop.isClear.push_back(clear);
    count += clear;
  }
  if (2 * count < colors.size()) return std::nullopt;
  return backdrop;
}

void PendingBatch::attachSecondaryScene() {
  capturedSurfaces.collect(batch);
  const bool isSeen = p_.clock.shows || (batch.key().framebuffer == 0 && !p_.clock.reads);
  if (!isSeen && batch.holdsData()) batch.dropImageChanges();
  if (batch.key().layers != BatchKey::Layers::visibility)
    p_.surfaces.objects.number(batch.key(), batch.unnumbered());
  const uint64_t frame = p_.surfaces.views.frameOf(batch.key(), batch.waiting());
  batch.setViewFrame(frame);
  if (p_.clock.watchesOffscreen(batch.waiting().settings)) [[unlikely]] {
    const scene::Region& region = batch.waiting().region;
    batch.setLightMode(p_.clock.offscreenMode({region.width, region.height}, frame));
  }
  const bool isLast = p_.clock.shows && batch.key().framebuffer == 0 && p_.shadow.info.doubleBuffered;
  batch.setSecondaryScene(p_.surfaces.views.secondaryScene(batch.key(), batch.waiting(), isLast));
  batch.setExtent(p_.surfaces.views.extentOf(batch.waiting()));
  batch.stand(p_.surfaces.views.groundOf(batch.key(), batch.waiting()), backdrop());
}

/// Null: no background is shown.
std::shared_ptr<const scene::Backdrop> PendingBatch::backdrop() {
  const BatchKey& key = batch.key();
  const scene::Snapshot& s = batch.waiting();
  const auto clear = p_.surfaces.views.paintsOver(key, s);
  if (!clear) return nullptr;
  try {
    const std::optional<ClearedTarget>& target = p_.cleared.target();
    const bool untouched =
        target && target->framebuffer == key.framebuffer && contains(target->region, s.region);
    if (untouched) return std::make_shared<const scene::Backdrop>();
    p_.shadow.errors.keepPending();
    std::vector<uint32_t> colors;
    if (presenter.reader().readColors(p_.shadow.real, s.region, colors)) {
      const auto where = backdropWhere(colors, clear->color);
      return where ? std::make_shared<const scene::Backdrop>(*where) : nullptr;
    }
    // Multisampled framebuffers.
    if (clear->drawsBefore == p_.counts.statistics.drawsRasterised)
      return std::make_shared<const scene::Backdrop>();
    log::once(
        log::Level::warning, "background",
        "background: the pixels of this framebuffer cannot be read, so the program's own background stays");
  } catch (const std::exception&) {
    log::once(log::Level::warning, "background", "out of memory: the program's own background stays");
  }
  return nullptr;
}

}  // namespace gluray::gl
