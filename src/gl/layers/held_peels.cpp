#include "gl/layers/held_peels.h"

#include <algorithm>
#include <utility>

namespace gluray::gl {

uint64_t HeldPeels::trianglesIn(GLenum mode, const Elements& elements) {
  return countTriangles(mode, static_cast<uint64_t>(elements.count)) * elements.repeats();
}

bool HeldPeels::holdsLabels() const {
  const std::vector<ProgramDraw>& draws = peeling_.target.depths.draws;
  return std::all_of(draws.begin(), draws.end(),
                     [](const ProgramDraw& draw) { return isLabel(draw.mode, draw.elements); });
}

void HeldPeels::pause() { peeling_.pauses.failed(peeling_.pass, holdsLabels()); }

void HeldPeels::end() {
  peeling_.stage = Peeling::Stage::none;
  peeling_.target = {};
  peeling_.layers.reset();
  peeling_.traced.reset();
}

void HeldPeels::countHeld() {
  const auto count = [&](const HeldPass& pass) {
    for (const ProgramDraw& draw : pass.draws)
      p_.counts.rasterised(Reason::programPass, draw.elements.type ? DrawPath::elements : DrawPath::arrays,
                           PrimitiveClass::surfaces, trianglesIn(draw.mode, draw.elements));
  };
  count(peeling_.target.depths);
  std::for_each(peeling_.target.later.begin(), peeling_.target.later.end(), count);
}

void HeldPeels::giveUp() {
  if (peeling_.stage == Peeling::Stage::none) return;
  p_.cleared.forget();
  // The program's query must not count these draws. It has not counted anything yet: end it and begin it
  // again.
  const bool counts = asks() && p_.shadow.activeQueries > 0;
  if (counts) p_.shadow.real.EndQuery(peeling_.query);
  peeling_.stage = Peeling::Stage::none;
  pause();
  LayersTarget& target = peeling_.target;
  target.image.clear();
  scene::SnapshotPtr snapshot = peeling_.traced;
  if (!p_.pending.batch.empty() && p_.pending.batch.key().layers == BatchKey::Layers::peeled) {
    for (ProgramDraw& draw : p_.pending.batch.takeProgramDraws())
      target.surfaces.draws.push_back(std::move(draw));
    snapshot = p_.pending.batch.takeSnapshot();
  }
  if (snapshot) p_.counts.asRasterised(*snapshot, Reason::programPass);
  p_.pending.withdrawPeeled();
  const PresentResult result = p_.pending.presenter.layers().present(p_.shadow.real, nullptr, target, true);
  if (result.pendingError != GL_NO_ERROR) p_.shadow.errors.set(result.pendingError);
  countHeld();
  if (counts) p_.shadow.real.BeginQuery(peeling_.query, peeling_.queryName);
  end();
  if (result.outcome != PresentResult::rasterised)
    p_.failsafe.fail(scene::Loss::tracing,
                     result.why.empty() ? "held draws could not be drawn" : result.why.c_str());
}

}  // namespace gluray::gl
