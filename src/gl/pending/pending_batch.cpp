#include "gl/pending/pending_batch.h"

#include "base/log.h"
#include "base/process_exit.h"
#include "gl/pending/address_space_gate.h"
#include "gl/real/draw_binding.h"
#include "gl/real/errors.h"

#include <bit>
#include <cmath>
#include <string>
#include <utility>

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

}  // namespace gluray::gl
