#include "gl/pending/pending_batch.h"

#include "base/log.h"
#include "base/processes/process_exit.h"
#include "gl/batch/clears.h"
#include "gl/pending/address_space_gate.h"
#include "gl/pending/cleared_pixels.h"
#include "gl/real/draw_binding.h"
#include "gl/real/errors.h"

#include <bit>
#include <cmath>
#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace gluray::gl {

Reason reasonOf(scene::Loss loss) {
  switch (loss) {
    case scene::Loss::draws: return Reason::untraceable;
    case scene::Loss::frames: return Reason::shortage;
    default: return Reason::failure;
  }
}

bool PendingBatch::canTrace() {
  if (supported_) return *supported_;
  std::string why;
  supported_ = presenter.supports(p_.shadow.real, p_.shadow.info.core, why);
  if (!*supported_)
    log::once(log::Level::warning, "support",
              "this OpenGL cannot show traced images (" + why + "): the real OpenGL draws everything");
  return *supported_;
}

HeldBatch PendingBatch::hold(std::string_view where) {
  HeldBatch held{batch.key(), batch.takeSnapshot(), batch.takeProgramDraws()};
  if (p_.counts.decisions()) [[unlikely]]
    p_.counts.decisions()->batch(held.key, held.snapshot->instances.size(), where);
  p_.surfaces.passes.flushed(held.snapshot);
  p_.surfaces.traced(held.key, held.snapshot);
  return held;
}

void PendingBatch::presentLate(HeldBatch held, bool known) {
  const RealGl& real = p_.shadow.real;
  const bool isShort = addressSpaceIsShort();
  p_.shadow.current.shelve(real);
  const PresentResult result = [&] {
    const DrawBinding binding(real, held.key.framebuffer);
    return presenter.present(real, held.snapshot,
                             {.depthFunc = held.key.depthFunc,
                              .core = p_.shadow.info.core,
                              .rasterise = isShort,
                              .programDraws = std::move(held.draws),
                              .wish = known ? p_.clock.wishAsShown() : p_.clock.wish(),
                              .keepsPixels = isRelightable(held.key, *held.snapshot)});
  }();
  if (result.written) p_.surfaces.views.wrote(held.snapshot, result.written);
  takeResult(result, known);
  if (result.outcome == PresentResult::traced) return;
  const bool costsFrames = isShort && result.outcome == PresentResult::rasterised;
  const scene::Loss loss = costsFrames ? scene::Loss::frames : result.loss();
  p_.counts.asRasterised(*held.snapshot, reasonOf(loss));
  p_.failsafe.fail(loss, costsFrames ? kAddressSpaceIsShort : result.reason());
}

void PendingBatch::takeResult(const PresentResult& result, bool known) {
  p_.shadow.latch.restore(p_.shadow.real);
  if (result.pendingError != GL_NO_ERROR) p_.shadow.errors.set(result.pendingError);
  p_.clock.drawn();
  if (p_.counts.decisions()) [[unlikely]]
    p_.counts.decisions()->presented(result, known);
  Statistics& statistics = p_.counts.statistics;
  statistics.presentSeconds += result.presentSeconds;
  if (!known) {
    ++statistics.flushes;
    // Windows are made before they are drawn into; later windows meet a later power of two.
    if (std::has_single_bit(uint64_t{statistics.flushes})) watchForExit();
  }
  if (!known && result.repeated) ++statistics.repeated;
  statistics.lightPasses += result.passes;
  if (std::isfinite(result.noise)) statistics.lightNoise = result.noise;
  statistics.buildSeconds += result.cost.buildSeconds;
  statistics.traceSeconds += result.cost.traceSeconds;
  statistics.blasBuilds += result.cost.blasBuilds;
  statistics.blasRefinements += result.cost.blasRefinements;
  if (known && result.repeated) return;
  if (!result.repeated) statistics.bvhBytes = result.cost.bvhBytes;  // repeated images do not report it
  statistics.blasRefining = result.cost.blasRefining;
}

void PendingBatch::attachSecondaryScene() {
  capturedSurfaces.collect(batch);
  const bool isSeen = p_.clock.shows || (batch.key().framebuffer == 0 && !p_.clock.reads);
  const bool isData = !isSeen && batch.holdsData();
  const bool isInset = !isData && p_.surfaces.views.isLeftAlone(batch.key(), batch.waiting());
  if (isData) batch.dropImageChanges();
  if (isInset) batch.dropLight();
  batch.setUpwardAxis(p_.surfaces.views.upwardAxisOf(batch.key(), batch.waiting()));
  if (batch.key().layers != BatchKey::Layers::visibility)
    p_.surfaces.objects.number(batch.key(), batch.unnumbered());
  const uint64_t frame = p_.surfaces.views.frameOf(batch.key(), batch.waiting());
  batch.setViewFrame(frame, p_.counts.statistics.frames);
  if (p_.clock.watchesOffscreen(batch.waiting().settings)) [[unlikely]] {
    const scene::Region& region = batch.waiting().region;
    batch.setLightMode(p_.clock.offscreenMode({region.width, region.height}, frame));
  }
  const bool isLast = p_.clock.shows && batch.key().framebuffer == 0 && p_.shadow.info.doubleBuffered;
  const bool isAlone = isData || isInset;
  batch.setSecondaryScene(isAlone ? nullptr
                                  : p_.surfaces.views.secondaryScene(batch.key(), batch.waiting(), isLast));
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
