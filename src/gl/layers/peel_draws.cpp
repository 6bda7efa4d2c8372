// The depth pass and the first peel of dual depth peeling, and the functions that all layers share.
#include "gl/layers/layer_draws.h"
#include "gl/layers/peel_outputs.h"
#include "gl/programs/uniforms.h"
#include "gl/real/errors.h"
#include "gl/real/state_queries.h"
#include "gl/state/output_state.h"

#include <GL/glext.h>

#include <algorithm>
#include <utility>

namespace gluray::gl {
namespace {

uint64_t trianglesOf(const ProgramDraw& draw) {
  return countTriangles(draw.mode, static_cast<uint64_t>(draw.elements.count)) * draw.elements.repeats();
}

}  // namespace

Family::Pass passOf(const ProgramState& program) {
  return program.known && program.known->family ? program.known->family->pass : Family::Pass::none;
}

BatchKey::Layers layersOf(const ProgramState& program) {
  switch (passOf(program)) {
    case Family::Pass::peel: return BatchKey::Layers::peeled;
    case Family::Pass::sum: return BatchKey::Layers::summed;
    default: return BatchKey::Layers::none;
  }
}

bool LayerDraws::start(const BatchKey& key, const glm::dmat4& modelview) {
  return key.layers == BatchKey::Layers::peeled ? startPeeled(key, modelview) : startSums(key, modelview);
}

/// Whether draws now fill a framebuffer object of the viewport's size and keep the maximum (GL_MAX).
bool LayerDraws::peelsIntoAll() const {
  const bool open =
      !p_.shadow.raster().scissorTest || p_.shadow.viewport().scissor == p_.shadow.viewport().box;
  return open && p_.shadow.target().framebuffer != 0 && p_.shadow.target().samples == 1 &&
         p_.shadow.viewport().box.x == 0 && p_.shadow.viewport().box.y == 0 &&
         p_.shadow.viewport().box.z > 0 && p_.shadow.viewport().box.w > 0 &&
         keepsLargest(p_.shadow.real, p_.shadow.rare());
}

bool LayerDraws::beginHolding() {
  const ProgramState& program = p_.shadow.program();
  const GLint unit = inputUnit(program);
  if (unit < 0 || !peelsIntoAll() || !peeling_.mayBegin()) return false;
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
  peeling_.traced.reset();
  peeling_.stage = Peeling::Stage::depths;
  return true;
}

bool LayerDraws::holdDepths(GLenum mode, const Elements& elements, uint64_t triangles) {
  using Stage = Peeling::Stage;
  if (p_.failsafe.aside() || p_.shadow.info.off || p_.shadow.activeQueries > 0 ||
      !p_.shadow.settings.quirks.has(Quirk::depthPeeling) || !p_.pending.canTrace())
    return false;
  if (p_.shadow.attributes().reason != Reason::traced || !p_.shadow.program().uniforms) return false;
  p_.shadow.errors.keepPending();
  if (peeling_.stage == Stage::surfaces || peeling_.stage == Stage::peels) {
    p_.flush.flushBatch();
    end();
  }
  if (peeling_.stage == Stage::none) {
    if (p_.clock.leavesAlone(triangles, p_.shadow.viewportPixels()) || !beginHolding()) return false;
  } else if (!peelsIntoAll() || peeling_.target.depths.viewport != p_.shadow.viewport().box ||
             peeling_.depthsFound !=
                 outputOf(p_.shadow.real, *p_.shadow.program().known, outputsOf(p_.shadow))) {
    return false;
  }
  const ProgramState& program = p_.shadow.program();
  peeling_.target.depths.draws.push_back(captureProgramDraw(
      p_.shadow.real, program.known->program, program.uniforms, p_.shadow.attributes(), mode, elements));
  return true;
}

Reason LayerDraws::classifySeenThrough(PrimitiveClass kind) {
  // The program's reason is more useful to the user than the kind of primitive.
  if (p_.shadow.program().reason != Reason::traced) return p_.shadow.program().reason;
  if (kind == PrimitiveClass::points) return Reason::points;
  if (kind == PrimitiveClass::lines) return Reason::lines;
  if (p_.shadow.attributes().reason != Reason::traced) return p_.shadow.attributes().reason;
  if (!p_.shadow.info.core && !p_.shadow.clipPlanes().empty()) return Reason::program;
  if (p_.shadow.program().known->program.blocks) p_.shadow.expire(kProgram);
  p_.shadow.errors.keepPending();
  return Reason::traced;
}

Reason LayerDraws::classifyPeel(PrimitiveClass kind) {
  using Stage = Peeling::Stage;
  if (p_.failsafe.aside()) return p_.failsafe.reason();
  if (peeling_.stage == Stage::none || p_.shadow.activeQueries > 0) return Reason::programPass;
  if (const Reason reason = classifySeenThrough(kind); reason != Reason::traced) return reason;
  if (inputTexture(p_.shadow.real, p_.shadow.program()) != peeling_.depthsFound)
    return Reason::programPass;  // a later peel
  if (!peelsIntoAll() || p_.shadow.viewport().box != peeling_.target.depths.viewport)
    return Reason::programPass;
  LayersTarget& target = peeling_.target;
  // Labels face the viewer: they would be new meshes in every frame.
  const auto isQuad = [](const ProgramDraw& draw) {
    return draw.mode != GL_POINTS && trianglesOf(draw) <= 2;  // points may be impostors
  };
  if (std::all_of(target.depths.draws.begin(), target.depths.draws.end(), isQuad)) return Reason::programPass;
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

bool LayerDraws::startPeeled(const BatchKey& key, const glm::dmat4& modelview) {
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

bool LayerDraws::haveSurfaces() const {
  const scene::Snapshot& s = p_.pending.batch.waiting();
  const auto isImage = [&](const scene::Instance& instance) {
    const auto& textures = s.shadings[instance.shading].textures;
    return std::any_of(textures.begin(), textures.end(),
                       [](const scene::Texture& t) { return !t.image->opaque; });
  };
  return !std::all_of(s.instances.begin(), s.instances.end(), isImage);
}

PresentResult LayerDraws::present(const scene::SnapshotPtr& snapshot, const BatchKey& key) {
  LayersTarget& target = peeling_.target;
  for (ProgramDraw& draw : p_.pending.batch.takeProgramDraws())
    target.surfaces.draws.push_back(std::move(draw));
  target.wish = p_.clock.wish();
  target.mayAsk = mayAsk();
  PresentResult result = p_.pending.presenter.layers().present(p_.shadow.real, snapshot, target, false);
  if (result.outcome == PresentResult::traced) {
    noteUse(Quirk::depthPeeling);
    peeling_.tracedKey = key;
    peeling_.traced = snapshot;
    target.written = result.image.empty();
    target.written ? peeling_.succeeded() : ask(result);
  } else {
    if (result.layers) {
      peeling_.failed();
      countHeld();
    }
    end();
  }
  return result;
}

void LayerDraws::end() {
  peeling_.stage = Peeling::Stage::none;
  peeling_.target = {};
  peeling_.layers.reset();
  peeling_.traced.reset();
}

/// Counts the held draws, which the real OpenGL has drawn, as rasterised.
void LayerDraws::countHeld() {
  const auto count = [&](const HeldPass& pass) {
    for (const ProgramDraw& draw : pass.draws)
      p_.counts.rasterised(Reason::programPass, draw.elements.type ? DrawPath::elements : DrawPath::arrays,
                           PrimitiveClass::surfaces, trianglesOf(draw));
  };
  count(peeling_.target.depths);
  std::for_each(peeling_.target.later.begin(), peeling_.target.later.end(), count);
}

void LayerDraws::giveUp() {
  if (peeling_.stage == Peeling::Stage::none) return;
  p_.cleared.forget();
  // The program's query must not count these draws. It has not counted anything yet: end it and begin it
  // again.
  const bool counts = asks() && p_.shadow.activeQueries > 0;
  if (counts) p_.shadow.real.EndQuery(peeling_.query);
  peeling_.stage = Peeling::Stage::none;
  peeling_.failed();
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

void LayerDraws::meetRasterDraw() {
  bool meets = peeling_.stage == Peeling::Stage::depths || asks() ||
               (!p_.pending.batch.empty() && p_.pending.batch.key().layers == BatchKey::Layers::peeled);
  // Once the layers are traced, only a draw into their result texture ends the peeling.
  if (!meets)
    for (const HeldPass::Output& output : outputsOf(p_.shadow))
      meets |= output.texture == peeling_.target.result;
  if (meets)
    giveUp();
  else
    end();
}

void LayerDraws::clearing() {
  peeling_.emptied = 0;
  if (peeling_.stage != Peeling::Stage::depths) return;
  for (const HeldPass::Output& output : outputsOf(p_.shadow))
    if (output.texture == peeling_.depthsFound) return giveUp();
}

void LayerDraws::programChanges(GLuint program) noexcept {
  const auto draws = [&](const HeldPass& pass) {
    return std::any_of(pass.draws.begin(), pass.draws.end(),
                       [&](const ProgramDraw& draw) { return draw.program == program; });
  };
  const LayersTarget& target = peeling_.target;
  if (draws(target.depths) ||
      (asks() && (draws(target.surfaces) || std::any_of(target.later.begin(), target.later.end(), draws))))
    p_.failsafe.protect([&] { giveUp(); });
}

}  // namespace gluray::gl
