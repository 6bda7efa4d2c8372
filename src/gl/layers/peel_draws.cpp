#include "gl/layers/peel_draws.h"

#include "gl/layers/layer_programs.h"
#include "gl/layers/peel_outputs.h"
#include "gl/programs/uniforms.h"
#include "gl/real/errors.h"
#include "gl/real/state_queries.h"

#include <GL/glext.h>

#include <algorithm>
#include <utility>

namespace gluray::gl {

bool PeelDraws::beginHolding(GLenum mode, const Elements& elements) {
  const ProgramState& program = p_.shadow.program();
  const GLint unit = inputUnit(program);
  if (unit < 0 || !peelsIntoAll(p_.shadow)) return false;
  const PeelPauses::Pass pass{.framebuffer = p_.shadow.target().framebuffer,
                              .viewport = p_.shadow.viewport().box,
                              .mode = mode,
                              .label = HeldPeels::isLabel(mode, elements)};
  if (!peeling_.pauses.mayBegin(pass, p_.clock.frame)) return false;
  LayersTarget target;
  target.depths.outputs = outputsOf(p_.shadow);
  target.depths.viewport = p_.shadow.viewport().box;
  target.size = {p_.shadow.viewport().box.z, p_.shadow.viewport().box.w};
  target.opaqueDepth = inputTexture(p_.shadow.real, program);
  const GLuint found = outputOf(p_.shadow.real, *program.known, target.depths.outputs);
  if (found == 0 || target.opaqueDepth == 0 ||
      !p_.pending.presenter.layers().readDepths(p_.shadow.real, unit, target.size, target.opaqueDepths))
    return false;
  // A later replay must not overwrite other outputs, which the program leaves undefined.
  for (HeldPass::Output& output : target.depths.outputs)
    if (output.texture != found) output = {};
  auto layers = std::make_shared<scene::Layers>();
  layers->opaqueDepth.reserve(target.opaqueDepths.size());
  for (const glm::vec2& depths : target.opaqueDepths) layers->opaqueDepth.push_back(depths.y);
  layers->peels = peeling_.usual;
  peeling_.target = std::move(target);
  peeling_.layers = std::move(layers);
  peeling_.depthsFound = found;
  peeling_.pass = pass;
  peeling_.pauses.endPass();
  peeling_.traced.reset();
  peeling_.stage = Peeling::Stage::depths;
  return true;
}

bool PeelDraws::holdDepths(GLenum mode, const Elements& elements, uint64_t triangles) {
  using Stage = Peeling::Stage;
  if (p_.failsafe.aside() || p_.shadow.info.off || p_.shadow.activeQueries > 0 ||
      !p_.shadow.settings.quirks.has(Quirk::depthPeeling) || !p_.pending.canTrace())
    return false;
  if (p_.shadow.attributes().reason != Reason::traced || !p_.shadow.program().uniforms) return false;
  p_.shadow.errors.keepPending();
  if (peeling_.stage == Stage::surfaces || peeling_.stage == Stage::peels) {
    p_.flush.flushBatch();
    held_.end();
  }
  if (peeling_.stage == Stage::none) {
    if (p_.clock.leavesAlone(triangles, p_.shadow.viewportPixels()) || !beginHolding(mode, elements))
      return false;
  } else if (!peelsIntoAll(p_.shadow) || peeling_.target.depths.viewport != p_.shadow.viewport().box ||
             peeling_.depthsFound !=
                 outputOf(p_.shadow.real, *p_.shadow.program().known, outputsOf(p_.shadow))) {
    return false;
  }
  const ProgramState& program = p_.shadow.program();
  peeling_.target.depths.draws.push_back(captureProgramDraw(
      p_.shadow.real, program.known->program, program.uniforms, p_.shadow.attributes(), mode, elements));
  return true;
}

Reason PeelDraws::classify(PrimitiveClass kind) {
  using Stage = Peeling::Stage;
  if (p_.failsafe.aside()) return p_.failsafe.reason();
  peeling_.pauses.endPass();
  if (peeling_.stage == Stage::none || p_.shadow.activeQueries > 0) return Reason::programPass;
  if (const Reason reason = seenThroughReason(p_.shadow, kind); reason != Reason::traced) return reason;
  if (inputTexture(p_.shadow.real, p_.shadow.program()) != peeling_.depthsFound)
    return Reason::programPass;  // a later peel
  if (!peelsIntoAll(p_.shadow) || p_.shadow.viewport().box != peeling_.target.depths.viewport)
    return Reason::programPass;
  LayersTarget& target = peeling_.target;
  // Labels face the viewer: they would be new meshes in every frame.
  if (held_.holdsLabels()) return Reason::programPass;
  std::vector<HeldPass::Output> outputs = outputsOf(p_.shadow);
  const GLuint result = outputOf(p_.shadow.real, *p_.shadow.program().known, outputs);
  if (result == 0 || (peeling_.stage == Stage::surfaces && result != target.result))
    return Reason::programPass;
  target.result = result;
  target.surfaces.outputs = std::move(outputs);
  target.surfaces.viewport = p_.shadow.viewport().box;
  peeling_.stage = Stage::surfaces;
  return Reason::traced;
}

bool PeelDraws::start(const BatchKey& key, const glm::dmat4& modelview) {
  if (!p_.pending.batch.empty()) return p_.pending.batch.key() == key;
  if (peeling_.traced) {
    if (!(peeling_.tracedKey == key)) return false;
    p_.pending.batch.resume(key, *peeling_.traced);
  } else {
    p_.pending.batch.start(key, p_.shadow.target(), modelview, p_.shadow.settings, p_.clock.frame,
                           p_.pending.begin());
    p_.pending.batch.seeThrough(peeling_.layers);
  }
  return true;
}

bool PeelDraws::haveSurfaces() const {
  const scene::Snapshot& s = p_.pending.batch.waiting();
  const auto isImage = [&](const scene::Instance& instance) {
    const auto& textures = s.shadings[instance.shading].textures;
    return std::any_of(textures.begin(), textures.end(),
                       [](const scene::Texture& t) { return !t.image->opaque; });
  };
  return !std::all_of(s.instances.begin(), s.instances.end(), isImage);
}

PresentResult PeelDraws::present(const scene::SnapshotPtr& snapshot, const BatchKey& key) {
  LayersTarget& target = peeling_.target;
  for (ProgramDraw& draw : p_.pending.batch.takeProgramDraws())
    target.surfaces.draws.push_back(std::move(draw));
  target.wish = p_.clock.wish();
  target.mayAsk = later_.mayAsk();
  PresentResult result = p_.pending.presenter.layers().present(p_.shadow.real, snapshot, target, false);
  if (result.outcome == PresentResult::traced) {
    noteUse(Quirk::depthPeeling);
    peeling_.tracedKey = key;
    peeling_.traced = snapshot;
    target.written = result.image.empty();
    target.written ? peeling_.pauses.succeeded(peeling_.pass) : later_.ask(result);
  } else {
    if (result.layers) {
      held_.pause();
      held_.countHeld();
    }
    held_.end();
  }
  return result;
}

void PeelDraws::meetRasterDraw() {
  bool meets = peeling_.stage == Peeling::Stage::depths || held_.asks() ||
               (!p_.pending.batch.empty() && p_.pending.batch.key().layers == BatchKey::Layers::peeled);
  // Once the layers are traced, only a draw into their result texture ends the peeling.
  if (!meets)
    for (const HeldPass::Output& output : outputsOf(p_.shadow))
      meets |= output.texture == peeling_.target.result;
  if (meets)
    held_.giveUp();
  else
    held_.end();
}

void PeelDraws::clearing() {
  peeling_.emptied = 0;
  peeling_.pauses.endPass();
  if (peeling_.stage != Peeling::Stage::depths) return;
  for (const HeldPass::Output& output : outputsOf(p_.shadow))
    if (output.texture == peeling_.depthsFound) return held_.giveUp();
}

void PeelDraws::programChanges(GLuint program) noexcept {
  const auto draws = [&](const HeldPass& pass) {
    return std::any_of(pass.draws.begin(), pass.draws.end(),
                       [&](const ProgramDraw& draw) { return draw.program == program; });
  };
  const LayersTarget& target = peeling_.target;
  if (draws(target.depths) ||
      (held_.asks() &&
       (draws(target.surfaces) || std::any_of(target.later.begin(), target.later.end(), draws))))
    p_.failsafe.protect([&] { held_.giveUp(); });
}

}  // namespace gluray::gl
