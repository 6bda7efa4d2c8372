// Passes of dual depth peeling, and what holds for all layers.
#include "gl/context.h"
#include "gl/layers/layer_draws.h"
#include "gl/layers/peel_outputs.h"
#include "gl/programs/uniforms.h"
#include "gl/state/output_state.h"
#include "gl/state/state_queries.h"

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

bool LayerDraws::start(const BatchKey& key) {
  return key.layers == BatchKey::Layers::peeled ? startPeeled(key) : startSums(key);
}

/// Whether draws of now fill a framebuffer object of the viewport's size and keep the largest values.
bool LayerDraws::peelsIntoAll() const {
  const bool open = !c_.state.raster.scissorTest || c_.state.scissor == c_.state.viewport;
  return open && c_.state.target.framebuffer != 0 && c_.state.target.samples == 1 &&
         c_.state.viewport.x == 0 && c_.state.viewport.y == 0 && c_.state.viewport.z > 0 &&
         c_.state.viewport.w > 0 && keepsLargest(c_.real, c_.state.rare);
}

bool LayerDraws::beginHolding() {
  const ProgramState& program = c_.state.program;
  const GLint unit = inputUnit(program);
  if (unit < 0 || !peelsIntoAll() || !peeling_.mayBegin()) return false;
  LayersTarget target;
  target.depths.outputs = outputsOf(c_.real);
  target.depths.viewport = c_.state.viewport;
  target.size = {c_.state.viewport.z, c_.state.viewport.w};
  target.opaqueDepth = inputTexture(c_.real, program);
  const GLuint found = outputOf(c_.real, *program.known, target.depths.outputs);
  if (found == 0 || target.opaqueDepth == 0 ||
      !c_.presenter().layers().readDepths(c_.real, unit, target.size, target.opaqueDepths))
    return false;
  // What the program leaves undefined elsewhere must not come later than it would have.
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
  if (c_.aside() || c_.passthrough() || c_.activeQueries > 0 ||
      !c_.settings().quirks.has(Quirk::depthPeeling) || !c_.canTrace())
    return false;
  if (c_.attributes.reason != Reason::traced || !c_.state.program.uniforms) return false;
  if (const GLenum pending = c_.real.GetError()) c_.setError(pending);
  if (peeling_.stage == Stage::surfaces || peeling_.stage == Stage::peels) {
    c_.flushBatch();
    end();
  }
  if (peeling_.stage == Stage::none) {
    if (c_.leavesAlone(triangles) || !beginHolding()) return false;
  } else if (!peelsIntoAll() || peeling_.target.depths.viewport != c_.state.viewport ||
             peeling_.depthsFound != outputOf(c_.real, *c_.state.program.known, outputsOf(c_.real))) {
    return false;
  }
  const ProgramState& program = c_.state.program;
  peeling_.target.depths.draws.push_back(
      captureProgramDraw(c_.real, program.known->program, program.uniforms, c_.attributes, mode, elements));
  return true;
}

Reason LayerDraws::triageSeenThrough(PrimitiveClass kind) {
  // What keeps the program from being traced says more than what kind of primitive it draws.
  if (c_.state.program.reason != Reason::traced) return c_.state.program.reason;
  if (kind == PrimitiveClass::points) return Reason::points;
  if (kind == PrimitiveClass::lines) return Reason::lines;
  if (c_.attributes.reason != Reason::traced) return c_.attributes.reason;
  if (!c_.info().core && !c_.state.clipPlanes.empty()) return Reason::program;
  if (c_.state.program.known->program.blocks) c_.dirty |= kProgram;
  if (const GLenum pending = c_.real.GetError()) c_.setError(pending);
  return Reason::traced;
}

Reason LayerDraws::triagePeel(PrimitiveClass kind) {
  using Stage = Peeling::Stage;
  if (c_.aside()) return Reason::failure;
  if (peeling_.stage == Stage::none || c_.activeQueries > 0) return Reason::programPass;
  if (const Reason reason = triageSeenThrough(kind); reason != Reason::traced) return reason;
  if (inputTexture(c_.real, c_.state.program) != peeling_.depthsFound)
    return Reason::programPass;  // a later peel
  if (!peelsIntoAll() || c_.state.viewport != peeling_.target.depths.viewport) return Reason::programPass;
  LayersTarget& target = peeling_.target;
  // Labels, which turn with the viewer: they would be new meshes in every frame.
  const auto isQuad = [](const ProgramDraw& draw) {
    return draw.mode != GL_POINTS && trianglesOf(draw) <= 2;  // points may be figures
  };
  if (std::all_of(target.depths.draws.begin(), target.depths.draws.end(), isQuad)) return Reason::programPass;
  std::vector<HeldPass::Output> outputs = outputsOf(c_.real);
  const GLuint result = outputOf(c_.real, *c_.state.program.known, outputs);
  if (result == 0 || (peeling_.stage == Stage::surfaces && result != target.result))
    return Reason::programPass;
  target.result = result;
  target.surfaces.outputs = std::move(outputs);
  target.surfaces.viewport = c_.state.viewport;
  peeling_.stage = Stage::surfaces;
  return Reason::traced;
}

bool LayerDraws::startPeeled(const BatchKey& key) {
  if (!c_.batch().empty()) return c_.batch().key() == key;
  if (peeling_.traced) {
    if (!(peeling_.tracedKey == key)) return false;
    c_.batch().resume(key, *peeling_.traced);
  } else {
    c_.batch().start(key, c_.state, c_.settings(), c_.frame);
    c_.batch().seeThrough(peeling_.layers);
  }
  return true;
}

/// Whether there is more among them than pictures with holes, such as labels: those are to be as sharp as
/// ever.
bool LayerDraws::haveSurfaces() const {
  const scene::Snapshot& s = c_.batch().waiting();
  const auto isPicture = [&](const scene::Instance& instance) {
    const auto& textures = s.shadings[instance.shading].textures;
    return std::any_of(textures.begin(), textures.end(),
                       [](const scene::Texture& t) { return !t.image->opaque; });
  };
  return !std::all_of(s.instances.begin(), s.instances.end(), isPicture);
}

PresentResult LayerDraws::present(const scene::SnapshotPtr& snapshot, const BatchKey& key) {
  LayersTarget& target = peeling_.target;
  for (ProgramDraw& draw : c_.batch().takeProgramDraws()) target.surfaces.draws.push_back(std::move(draw));
  target.mayRepeat = !c_.measured();
  target.mayAsk = mayAsk();
  PresentResult result = c_.presenter().layers().present(c_.real, snapshot, target, false);
  if (result.outcome == PresentResult::traced) {
    noteUse(Quirk::depthPeeling);
    peeling_.tracedKey = key;
    peeling_.traced = snapshot;
    target.written = result.picture.empty();
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

/// Held draws that no picture was made of were made by the real OpenGL.
void LayerDraws::countHeld() {
  const auto count = [&](const HeldPass& pass) {
    for (const ProgramDraw& draw : pass.draws)
      c_.countRaster(Reason::programPass, draw.elements.type ? DrawPath::elements : DrawPath::arrays,
                     PrimitiveClass::surfaces, trianglesOf(draw));
  };
  count(peeling_.target.depths);
  std::for_each(peeling_.target.later.begin(), peeling_.target.later.end(), count);
}

void LayerDraws::giveUp() {
  if (peeling_.stage == Peeling::Stage::none) return;
  c_.forgetClear();
  // What is made now is not what the program counts. So far there is nothing to count.
  const bool counts = asks() && c_.activeQueries > 0;
  if (counts) c_.real.EndQuery(peeling_.query);
  peeling_.stage = Peeling::Stage::none;
  peeling_.failed();
  LayersTarget& target = peeling_.target;
  target.picture.clear();
  scene::SnapshotPtr snapshot = peeling_.traced;
  if (!c_.batch().empty() && c_.batch().key().layers == BatchKey::Layers::peeled) {
    for (ProgramDraw& draw : c_.batch().takeProgramDraws()) target.surfaces.draws.push_back(std::move(draw));
    snapshot = c_.batch().take();
  }
  if (snapshot) c_.countAsRasterised(*snapshot, Reason::programPass);
  const PresentResult result = c_.presenter().layers().present(c_.real, nullptr, target, true);
  if (result.pendingError != GL_NO_ERROR) c_.setError(result.pendingError);
  countHeld();
  if (counts) c_.real.BeginQuery(peeling_.query, peeling_.queryName);
  end();
  if (result.outcome != PresentResult::rasterised)
    c_.stepAside(result.why.empty() ? "what was held back could not be drawn" : result.why.c_str());
}

void LayerDraws::meetRasterDraw() {
  bool meets = peeling_.stage == Peeling::Stage::depths || asks() ||
               (!c_.batch().empty() && c_.batch().key().layers == BatchKey::Layers::peeled);
  // Once they are traced, only who joins them makes us give up.
  if (!meets)
    for (const HeldPass::Output& output : outputsOf(c_.real))
      meets |= output.texture == peeling_.target.result;
  if (meets)
    giveUp();
  else
    end();
}

void LayerDraws::clearing() {
  peeling_.emptied = 0;
  if (peeling_.stage != Peeling::Stage::depths) return;
  for (const HeldPass::Output& output : outputsOf(c_.real))
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
    c_.protect([&] { giveUp(); });
}

}  // namespace gluray::gl
