// Peels after the first one, whose layers are traced already: they are held back, and what the program counts
// to know when to end is what they would have written, until it has drawn as many as show all layers.
#include "gl/context.h"
#include "gl/layers/layer_draws.h"
#include "gl/layers/peel_limits.h"
#include "gl/layers/peel_outputs.h"
#include "gl/programs/uniforms.h"
#include "gl/state/state_queries.h"
#include "gl/window/clears.h"

#include <GL/glext.h>

#include <algorithm>
#include <utility>

namespace gluray::gl {
namespace {

/// The texture that farthest layers go to, among the three that the first peel writes; 0: it writes others.
GLuint behindOf(const LayersTarget& target) {
  if (target.surfaces.outputs.size() != 3) return 0;
  GLuint behind = 0, others = 0;
  for (const HeldPass::Output& output : target.surfaces.outputs) {
    if (output.texture == target.result || output.texture == target.opaqueDepth)
      ++others;
    else if (output.level == 0)
      behind = output.texture;
  }
  return others == 2 ? behind : 0;
}

/// Whether what is drawn is put over what is there, all channels of it, where no depth is tested.
bool putsOver(const RealGl& real, const RareState& has) {
  const auto is = [&](GLenum name, GLint value) { return integer(real, name) == value; };
  return isOn(real, GL_BLEND) && !isOn(real, GL_DEPTH_TEST) && !isOn(real, GL_STENCIL_TEST) &&
         is(GL_BLEND_EQUATION_RGB, GL_FUNC_ADD) && is(GL_BLEND_EQUATION_ALPHA, GL_FUNC_ADD) &&
         is(GL_BLEND_SRC_RGB, GL_ONE) && is(GL_BLEND_SRC_ALPHA, GL_ONE) &&
         is(GL_BLEND_DST_RGB, GL_ONE_MINUS_SRC_ALPHA) && is(GL_BLEND_DST_ALPHA, GL_ONE_MINUS_SRC_ALPHA) &&
         clearsInFull(real, has, GL_COLOR_BUFFER_BIT);
}

/// Whether a draw by a program of no family can be kept.
bool isInBuffers(const ArrayState& arrays, const Elements& elements) {
  const bool known = arrays.reason == Reason::traced || arrays.reason == Reason::arrayState;
  return known && !elements.type && !arrays.vertex.enabled &&
         std::all_of(arrays.generic.begin(), arrays.generic.end(),
                     [](const ArraySource& source) { return source.buffer != nullptr; });
}

/// Where the newest peel goes, the first one or a later one.
const std::vector<HeldPass::Output>& newestOutputs(const LayersTarget& target) {
  const auto isPeel = [](const HeldPass& pass) {
    return !pass.clear && pass.blend == HeldPass::Blend::largest;
  };
  const auto newest = std::find_if(target.later.rbegin(), target.later.rend(), isPeel);
  return newest == target.later.rend() ? target.surfaces.outputs : newest->outputs;
}

bool reads(const ProgramDraw& draw, GLuint texture) {
  return std::any_of(draw.textures.begin(), draw.textures.end(),
                     [&](const ProgramDraw::BoundTexture& t) { return t.name == texture; });
}

}  // namespace

bool LayerDraws::mayAsk() const { return c_.info().core && behindOf(peeling_.target) != 0; }

void LayerDraws::ask(PresentResult& result) {
  peeling_.stage = Peeling::Stage::peels;
  peeling_.counts = *result.layers;
  peeling_.target.picture = std::move(result.picture);
  peeling_.peel = 1;
  peeling_.input = peeling_.depthsFound;
  peeling_.behind = behindOf(peeling_.target);
  peeling_.blended = false;
}

/// Whether what is drawn now belongs to the first peel, of which a part was traced because a program was made
/// meanwhile.
bool LayerDraws::joinsFirstPeel() const {
  const ProgramState& program = c_.state.program;
  if (!peeling_.target.later.empty() || c_.activeQueries > 0 || passOf(program) != Family::Pass::peel ||
      program.reason != Reason::traced)
    return false;
  return inputTexture(c_.real, program) == peeling_.depthsFound;
}

bool LayerDraws::holdLater(GLenum mode, const Elements& elements) {
  if (joinsFirstPeel()) {
    peeling_.stage = Peeling::Stage::surfaces;
    peeling_.target.picture.clear();
    return false;
  }
  const glm::ivec4& viewport = peeling_.target.depths.viewport;
  glm::ivec4 now(0);
  c_.real.GetIntegerv(GL_VIEWPORT, &now.x);
  const glm::ivec4 box = scissorBox(c_.real);
  const bool known =
      c_.state.program.known &&
      (c_.activeQueries == 1 ? isInBuffers(c_.attributes, elements) : c_.attributes.reason == Reason::traced);
  const bool open = now == viewport &&
                    contains({box.x, box.y, box.z, box.w}, {viewport.x, viewport.y, viewport.z, viewport.w});
  if (const GLenum pending = c_.real.GetError()) c_.setError(pending);
  if (open && blendsRest()) {
    peeling_.usual = peeling_.peel;
    if (!traceAgain(peeling_.peel) || !showWaiting()) return false;
    peeling_.emptied = inputTexture(c_.real, c_.state.program);
    return true;
  }
  if (known && open && (c_.activeQueries == 1 ? addBlended(mode, elements) : addPeel(mode, elements)))
    return true;
  giveUp();
  return false;
}

bool LayerDraws::addPeel(GLenum mode, const Elements& elements) {
  const ProgramState& program = c_.state.program;
  if (c_.activeQueries > 0 || passOf(program) != Family::Pass::peel || !program.uniforms || !peelsIntoAll())
    return false;
  std::vector<HeldPass::Output> outputs = outputsOf(c_.real);
  const GLuint result = outputOf(c_.real, *program.known, outputs);
  const GLuint input = inputTexture(c_.real, program);
  if (result == 0 || input == 0) return false;
  std::vector<HeldPass>& later = peeling_.target.later;
  if (peeling_.blended) {
    if (input == peeling_.input || result == peeling_.target.result) return false;
    ++peeling_.peel;
    peeling_.input = input, peeling_.target.result = result, peeling_.blended = false;
    later.push_back({.outputs = std::move(outputs), .viewport = c_.state.viewport});
  } else if (peeling_.peel == 1 || input != peeling_.input || later.back().clear ||
             later.back().outputs != outputs) {
    return false;
  }
  later.back().draws.push_back(
      captureProgramDraw(c_.real, program.known->program, program.uniforms, c_.attributes, mode, elements));
  return true;
}

/// What puts the farthest layers of a peel over those before, and is counted.
bool LayerDraws::addBlended(GLenum mode, const Elements& elements) {
  const auto pixels = surelyWritten(peeling_.counts, peeling_.peel);
  if (peeling_.blended || !pixels || peeling_.query != GL_SAMPLES_PASSED || !putsOver(c_.real, c_.state.rare))
    return false;
  HeldPass pass{.outputs = outputsOf(c_.real),
                .viewport = peeling_.target.depths.viewport,
                .blend = HeldPass::Blend::over};
  if (pass.outputs.size() != 1 || pass.outputs[0].texture == peeling_.behind) return false;
  const Program& program = c_.state.program.known->program;
  pass.draws.push_back(
      captureProgramDraw(c_.real, program, readUniforms(c_.real, program), c_.attributes, mode, elements));
  if (!reads(pass.draws[0], peeling_.behind) ||
      !c_.presenter().layers().countPixels(c_.real, pass, peeling_.behind, peeling_.target.size, *pixels))
    return false;
  peeling_.target.later.push_back(std::move(pass));
  peeling_.blended = true;
  return true;
}

/// Whether what is drawn now is what the newest peel has left, over its farthest layers.
bool LayerDraws::blendsRest() const {
  const ProgramState& program = c_.state.program;
  if (!peeling_.blended || c_.activeQueries > 0 || passOf(program) != Family::Pass::peelRest ||
      !putsOver(c_.real, c_.state.rare) || outputsOf(c_.real) != peeling_.target.later.back().outputs)
    return false;
  const GLuint input = inputTexture(c_.real, program);
  const std::vector<HeldPass::Output>& newest = newestOutputs(peeling_.target);
  return input != 0 && input != peeling_.target.result && input != peeling_.behind &&
         std::find(newest.begin(), newest.end(), HeldPass::Output{input, 0}) != newest.end();
}

bool LayerDraws::drawsNothing() {
  if (!peeling_.emptied) return false;
  const ProgramState& program = c_.state.program;
  const bool rest = c_.activeQueries == 0 && passOf(program) == Family::Pass::peelRest;
  if (!rest || inputTexture(c_.real, program) != peeling_.emptied) peeling_.emptied = 0;
  return peeling_.emptied != 0;
}

/// The picture that waits becomes that of so many peels (scene::Layers::peels). False where it cannot, and
/// nothing waits any more.
bool LayerDraws::traceAgain(uint32_t peels) {
  if (peeling_.layers->peels == peels) return true;
  auto layers = std::make_shared<scene::Layers>(*peeling_.layers);
  layers->peels = peels;
  auto snapshot = std::make_shared<scene::Snapshot>(*peeling_.traced);
  snapshot->layers = layers;
  PresentResult result = c_.presenter().layers().trace(snapshot, peeling_.target);
  if (result.outcome != PresentResult::traced) {
    giveUp();
    return false;
  }
  peeling_.layers = std::move(layers);
  peeling_.traced = std::move(snapshot);
  peeling_.target.picture = std::move(result.picture);
  return true;
}

bool LayerDraws::clearsLater(GLbitfield mask) noexcept {
  if (!asks()) return false;
  bool held = false;
  c_.protect([&] {
    HeldPass pass{
        .outputs = outputsOf(c_.real), .viewport = peeling_.target.depths.viewport, .clear = glm::vec4(0)};
    const glm::ivec4 box = scissorBox(c_.real);
    const scene::Region all{0, 0, peeling_.target.size.x, peeling_.target.size.y};
    held = mask == GL_COLOR_BUFFER_BIT && c_.activeQueries == 0 && peeling_.blended &&
           !pass.outputs.empty() && contains({box.x, box.y, box.z, box.w}, all) &&
           clearsInFull(c_.real, c_.state.rare, mask);
    if (!held) return giveUp();
    c_.real.GetFloatv(GL_COLOR_CLEAR_VALUE, &pass.clear->x);
    peeling_.target.later.push_back(std::move(pass));
  });
  return held;
}

void LayerDraws::queryBegins(GLenum target, GLuint name) {
  if (holdsDepths()) return giveUp();
  if (!asks()) return;
  if (c_.activeQueries > 0) return giveUp();
  peeling_.query = target, peeling_.queryName = name;
  if (showsAll(peeling_.peel, peeling_.counts, peeling_.target.opaqueDepths.size())) {
    // Of more peels than the picture's, all count.
    if (peeling_.layers->peels >= peeling_.peel || traceAgain(0)) showWaiting();
  } else if (!surelyWritten(peeling_.counts, peeling_.peel))
    giveUp();
}

/// The program has drawn as many peels as show all layers, or is about to draw what they have left. False:
/// everything was drawn by the real OpenGL.
bool LayerDraws::showWaiting() {
  peeling_.stage = Peeling::Stage::none;
  c_.forgetClear();
  const PresentResult result = c_.presenter().layers().present(c_.real, nullptr, peeling_.target, false);
  if (result.pendingError != GL_NO_ERROR) c_.setError(result.pendingError);
  const bool shown = result.outcome == PresentResult::traced;
  if (shown) {
    peeling_.succeeded();
  } else {
    if (peeling_.traced) c_.countAsRasterised(*peeling_.traced, Reason::programPass);
    countHeld();
    c_.stepAside(result.why.empty() ? "layers that were traced could not be shown" : result.why.c_str());
  }
  end();
  return shown;
}

}  // namespace gluray::gl
