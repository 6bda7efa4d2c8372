// Passes of dual depth peeling: the Context's side of Peeling.
#include "gl/context.h"
#include "gl/output_state.h"
#include "gl/programs/uniforms.h"
#include "gl/state_queries.h"

#include <GL/glext.h>

#include <algorithm>
#include <utility>

namespace gluray::gl {
namespace {

constexpr GLuint kMostOutputs = 8;

/// Where the draw framebuffer's colours go; empty where that is not to textures alone.
std::vector<HeldPass::Output> outputsOf(const RealGl& real) {
  std::vector<HeldPass::Output> outputs;
  for (GLuint i = 0; i < kMostOutputs; ++i) {
    const auto buffer = static_cast<GLenum>(integer(real, GL_DRAW_BUFFER0 + i));
    outputs.emplace_back();
    if (buffer == GL_NONE) continue;
    const auto ask = [&](GLenum name) {
      GLint value = 0;
      real.GetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, buffer, name, &value);
      return value;
    };
    if (ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_TEXTURE) return {};
    outputs.back() = {static_cast<GLuint>(ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME)),
                      ask(GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL)};
  }
  while (!outputs.empty() && outputs.back().texture == 0) outputs.pop_back();
  return outputs;
}

/// The texture that the program's output goes to; 0: none, or not its level 0.
GLuint outputOf(const RealGl& real, const KnownProgram& known, const std::vector<HeldPass::Output>& outputs) {
  const GLint location = real.GetFragDataLocation(known.program.name, known.family->passOutput.c_str());
  if (location < 0 || static_cast<size_t>(location) >= outputs.size()) return 0;
  const HeldPass::Output& output = outputs[static_cast<size_t>(location)];
  return output.level == 0 ? output.texture : 0;
}

/// Unit that the family's input is looked up on; -1: none.
GLint inputUnit(const ProgramState& program) {
  const ProgramUniform* sampler = program.known->program.uniform(program.known->family->passInput);
  if (!sampler || sampler->type != GL_SAMPLER_2D || !program.uniforms) return -1;
  return (*program.uniforms)[sampler->first].integers[0];
}

GLuint boundTexture(const RealGl& real, GLint unit) {
  const GLint active = integer(real, GL_ACTIVE_TEXTURE);
  real.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  const GLint name = integer(real, GL_TEXTURE_BINDING_2D);
  real.ActiveTexture(static_cast<GLenum>(active));
  return static_cast<GLuint>(name);
}

uint64_t trianglesOf(const ProgramDraw& draw) {
  return countTriangles(draw.mode, static_cast<uint64_t>(draw.elements.count)) * draw.elements.repeats();
}

}  // namespace

Family::Pass Context::passOfProgram() const {
  const auto& known = state.program.known;
  return known && known->family ? known->family->pass : Family::Pass::none;
}

/// Whether draws of now fill a framebuffer object of the viewport's size and keep the largest values.
bool Context::peelsIntoAll() const {
  const bool open = !state.raster.scissorTest || state.scissor == state.viewport;
  return open && state.target.framebuffer != 0 && state.target.samples == 1 && state.viewport.x == 0 &&
         state.viewport.y == 0 && state.viewport.z > 0 && state.viewport.w > 0 &&
         keepsLargest(real, state.rare);
}

bool Context::beginLayers() {
  const ProgramState& program = state.program;
  const GLint unit = inputUnit(program);
  if (unit < 0 || !peelsIntoAll() || !peeling_.mayBegin()) return false;
  LayersTarget target;
  target.depths.outputs = outputsOf(real);
  target.depths.viewport = state.viewport;
  target.size = {state.viewport.z, state.viewport.w};
  target.opaqueDepth = boundTexture(real, unit);
  const GLuint found = outputOf(real, *program.known, target.depths.outputs);
  if (found == 0 || target.opaqueDepth == 0 ||
      !presenter_.readDepths(real, unit, target.size, target.opaqueDepths))
    return false;
  // What the program leaves undefined elsewhere must not come later than it would have.
  for (HeldPass::Output& output : target.depths.outputs)
    if (output.texture != found) output = {};
  auto layers = std::make_shared<scene::Layers>();
  layers->opaqueDepth.reserve(target.opaqueDepths.size());
  for (const glm::vec2& depths : target.opaqueDepths) layers->opaqueDepth.push_back(depths.y);
  peeling_.target = std::move(target);
  peeling_.layers = std::move(layers);
  peeling_.depthsFound = found;
  peeling_.traced.reset();
  peeling_.stage = Peeling::Stage::depths;
  return true;
}

bool Context::holdDepths(GLenum mode, const Elements& elements, uint64_t triangles) {
  using Stage = Peeling::Stage;
  if (aside_ || passthrough_ || activeQueries > 0 || !info_.settings.quirks.has(Quirk::depthPeeling) ||
      !canTrace())
    return false;
  if (attributes.reason != Reason::traced || !state.program.uniforms) return false;
  if (const GLenum pending = real.GetError()) setError(pending);
  if (peeling_.stage == Stage::surfaces) {
    present(false);
    endLayers();
  }
  if (peeling_.stage == Stage::none) {
    const bool small =
        choice_.way() == EngineChoice::Way::mixed && choice_.takesAlone(triangles, viewportPixels());
    if (small || !beginLayers()) return false;
  } else if (!peelsIntoAll() || peeling_.target.depths.viewport != state.viewport ||
             peeling_.depthsFound != outputOf(real, *state.program.known, outputsOf(real))) {
    return false;
  }
  const ProgramState& program = state.program;
  peeling_.target.depths.draws.push_back(
      captureProgramDraw(real, program.known->program, program.uniforms, attributes, mode, elements));
  return true;
}

Reason Context::triagePeel(PrimitiveClass kind) {
  using Stage = Peeling::Stage;
  if (aside_) return Reason::failure;
  if (peeling_.stage == Stage::none || activeQueries > 0) return Reason::programPass;
  if (const Reason reason = triageSeenThrough(kind); reason != Reason::traced) return reason;
  const GLint unit = inputUnit(state.program);
  if (unit < 0 || boundTexture(real, unit) != peeling_.depthsFound)
    return Reason::programPass;  // a later peel
  if (!peelsIntoAll() || state.viewport != peeling_.target.depths.viewport) return Reason::programPass;
  LayersTarget& target = peeling_.target;
  // Labels, which turn with the viewer: they would be new meshes in every frame.
  const auto isQuad = [](const ProgramDraw& draw) {
    return draw.mode != GL_POINTS && trianglesOf(draw) <= 2;  // points may be figures
  };
  if (std::all_of(target.depths.draws.begin(), target.depths.draws.end(), isQuad)) return Reason::programPass;
  std::vector<HeldPass::Output> outputs = outputsOf(real);
  const GLuint result = outputOf(real, *state.program.known, outputs);
  if (result == 0 || (peeling_.stage == Stage::surfaces && result != target.result))
    return Reason::programPass;
  target.result = result;
  target.surfaces.outputs = std::move(outputs);
  target.surfaces.viewport = state.viewport;
  peeling_.stage = Stage::surfaces;
  return Reason::traced;
}

bool Context::startLayers(const BatchKey& key) {
  if (!batch_.empty()) return batch_.key() == key;
  if (peeling_.traced) {
    if (!(peeling_.tracedKey == key)) return false;
    batch_.resume(key, *peeling_.traced);
  } else {
    batch_.start(key, state, info_.settings, frame);
    batch_.seeThrough(peeling_.layers);
  }
  return true;
}

/// Whether there is more among them than pictures with holes, such as labels: those are to be as sharp as
/// ever.
bool Context::layersHaveSurfaces() const {
  const scene::Snapshot& s = batch_.waiting();
  const auto isPicture = [&](const scene::Instance& instance) {
    const auto& textures = s.shadings[instance.shading].textures;
    return std::any_of(textures.begin(), textures.end(),
                       [](const scene::Texture& t) { return !t.image->opaque; });
  };
  return !std::all_of(s.instances.begin(), s.instances.end(), isPicture);
}

PresentResult Context::presentLayers(const scene::SnapshotPtr& snapshot, const BatchKey& key) {
  LayersTarget& target = peeling_.target;
  for (ProgramDraw& draw : batch_.takeProgramDraws()) target.surfaces.draws.push_back(std::move(draw));
  target.mayRepeat = !choice_.wantsStop();
  PresentResult result = presenter_.presentLayers(real, snapshot, target, false);
  if (result.outcome == PresentResult::traced) {
    noteUse(Quirk::depthPeeling);
    target.written = true;
    peeling_.tracedKey = key;
    peeling_.traced = snapshot;
    peeling_.succeeded();
  } else {
    endLayers();
  }
  return result;
}

void Context::endLayers() {
  peeling_.stage = Peeling::Stage::none;
  peeling_.target = {};
  peeling_.layers.reset();
  peeling_.traced.reset();
}

void Context::giveUpLayers() {
  if (peeling_.stage == Peeling::Stage::none) return;
  forgetClear();
  peeling_.stage = Peeling::Stage::none;
  peeling_.failed();
  LayersTarget& target = peeling_.target;
  scene::SnapshotPtr snapshot = peeling_.traced;
  if (!batch_.empty() && batch_.key().layers == BatchKey::Layers::peeled) {
    for (ProgramDraw& draw : batch_.takeProgramDraws()) target.surfaces.draws.push_back(std::move(draw));
    snapshot = batch_.take();
  }
  if (snapshot) countAsRasterised(*snapshot);
  const PresentResult result = presenter_.presentLayers(real, nullptr, target, true);
  if (result.pendingError != GL_NO_ERROR) setError(result.pendingError);
  for (const ProgramDraw& draw : target.depths.draws)
    countRaster(Reason::programPass, draw.elements.type ? DrawPath::elements : DrawPath::arrays,
                PrimitiveClass::surfaces, trianglesOf(draw));
  endLayers();
  if (result.outcome != PresentResult::rasterised)
    stepAside(result.why.empty() ? "what was held back could not be drawn" : result.why.c_str());
}

void Context::layersMeetRasterDraw() {
  bool meets = peeling_.stage == Peeling::Stage::depths ||
               (!batch_.empty() && batch_.key().layers == BatchKey::Layers::peeled);
  // Once they are traced, only who joins them makes us give up.
  if (!meets)
    for (const HeldPass::Output& output : outputsOf(real)) meets |= output.texture == peeling_.target.result;
  if (meets)
    giveUpLayers();
  else
    endLayers();
}

void Context::clearsLayers() {
  if (peeling_.stage != Peeling::Stage::depths) return;
  for (const HeldPass::Output& output : outputsOf(real))
    if (output.texture == peeling_.depthsFound) return giveUpLayers();
}

void Context::programChanges(GLuint program) noexcept {
  const auto& held = peeling_.target.depths.draws;
  if (std::any_of(held.begin(), held.end(), [&](const ProgramDraw& draw) { return draw.program == program; }))
    protect([&] { giveUpLayers(); });
}

}  // namespace gluray::gl
