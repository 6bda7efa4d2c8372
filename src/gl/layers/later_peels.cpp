#include "gl/layers/later_peels.h"

#include "gl/batch/clears.h"
#include "gl/layers/layer_programs.h"
#include "gl/layers/peel_limits.h"
#include "gl/layers/peel_outputs.h"
#include "gl/programs/uniforms.h"
#include "gl/real/errors.h"
#include "gl/real/state_queries.h"

#include <GL/glext.h>

#include <algorithm>
#include <utility>

namespace gluray::gl {
namespace {

/// The one of the first peel's three outputs that receives farthest layers; 0 if the peel has other outputs.
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

/// Whether draws blend over the framebuffer with premultiplied alpha in all channels, without depth or
/// stencil test.
bool putsOver(const RealGl& real, const RareState& has) {
  const auto is = [&](GLenum name, GLint value) { return integer(real, name) == value; };
  return isOn(real, GL_BLEND) && !isOn(real, GL_DEPTH_TEST) && !isOn(real, GL_STENCIL_TEST) &&
         is(GL_BLEND_EQUATION_RGB, GL_FUNC_ADD) && is(GL_BLEND_EQUATION_ALPHA, GL_FUNC_ADD) &&
         is(GL_BLEND_SRC_RGB, GL_ONE) && is(GL_BLEND_SRC_ALPHA, GL_ONE) &&
         is(GL_BLEND_DST_RGB, GL_ONE_MINUS_SRC_ALPHA) && is(GL_BLEND_DST_ALPHA, GL_ONE_MINUS_SRC_ALPHA) &&
         clearsInFull(real, has, GL_COLOR_BUFFER_BIT);
}

/// Whether a draw by a program without a family can be kept, because all its arrays are in buffers.
bool isInBuffers(const ArrayState& arrays, const Elements& elements) {
  const bool known = arrays.reason == Reason::traced || arrays.reason == Reason::arrayState;
  return known && !elements.type && !arrays.vertex.enabled &&
         std::all_of(arrays.generic.begin(), arrays.generic.end(),
                     [](const ArraySource& source) { return source.buffer != nullptr; });
}

/// The outputs of the newest peel, which may be the first one.
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

bool LaterPeels::mayAsk() const { return p_.shadow.info.core && behindOf(peeling_.target) != 0; }

void LaterPeels::ask(PresentResult& result) {
  peeling_.stage = Peeling::Stage::peels;
  peeling_.counts = *result.layers;
  peeling_.target.image = std::move(result.image);
  peeling_.peel = 1;
  peeling_.input = peeling_.depthsFound;
  peeling_.behind = behindOf(peeling_.target);
  peeling_.blended = false;
}

/// Whether the current draw belongs to the first peel, and a part of that peel was traced early because the
/// program linked a shader program in between.
bool LaterPeels::joinsFirstPeel() const {
  const ProgramState& program = p_.shadow.program();
  if (!peeling_.target.later.empty() || p_.shadow.activeQueries > 0 ||
      passOf(program) != Family::Pass::peel || program.reason != Reason::traced)
    return false;
  return inputTexture(p_.shadow.real, program) == peeling_.depthsFound;
}

bool LaterPeels::holdLater(GLenum mode, const Elements& elements) {
  if (joinsFirstPeel()) {
    peeling_.stage = Peeling::Stage::surfaces;
    peeling_.target.image.clear();
    return false;
  }
  const glm::ivec4& viewport = peeling_.target.depths.viewport;
  glm::ivec4 now(0);
  p_.shadow.real.GetIntegerv(GL_VIEWPORT, &now.x);
  const glm::ivec4 box = scissorBox(p_.shadow.real);
  const bool known = p_.shadow.program().known &&
                     (p_.shadow.activeQueries == 1 ? isInBuffers(p_.shadow.attributes(), elements)
                                                   : p_.shadow.attributes().reason == Reason::traced);
  const bool open = now == viewport &&
                    contains({box.x, box.y, box.z, box.w}, {viewport.x, viewport.y, viewport.z, viewport.w});
  p_.shadow.errors.keepPending();
  if (open && blendsRest()) {
    peeling_.usual = peeling_.peel;
    if (!traceAgain(peeling_.peel) || !showWaiting()) return false;
    peeling_.emptied = inputTexture(p_.shadow.real, p_.shadow.program());
    return true;
  }
  if (known && open && (p_.shadow.activeQueries == 1 ? addBlended(mode, elements) : addPeel(mode, elements)))
    return true;
  held_.giveUp();
  return false;
}

bool LaterPeels::addPeel(GLenum mode, const Elements& elements) {
  const ProgramState& program = p_.shadow.program();
  if (p_.shadow.activeQueries > 0 || passOf(program) != Family::Pass::peel || !program.uniforms ||
      !peelsIntoAll(p_.shadow))
    return false;
  std::vector<HeldPass::Output> outputs = outputsOf(p_.shadow);
  const GLuint result = outputOf(p_.shadow.real, *program.known, outputs);
  const GLuint input = inputTexture(p_.shadow.real, program);
  if (result == 0 || input == 0) return false;
  std::vector<HeldPass>& later = peeling_.target.later;
  if (peeling_.blended) {
    if (input == peeling_.input || result == peeling_.target.result) return false;
    ++peeling_.peel;
    peeling_.input = input, peeling_.target.result = result, peeling_.blended = false;
    later.push_back({.outputs = std::move(outputs), .viewport = p_.shadow.viewport().box});
  } else if (peeling_.peel == 1 || input != peeling_.input || later.back().clear ||
             later.back().outputs != outputs) {
    return false;
  }
  later.back().draws.push_back(captureProgramDraw(p_.shadow.real, program.known->program, program.uniforms,
                                                  p_.shadow.attributes(), mode, elements));
  return true;
}

/// Holds back the draw, counted by a query, that blends a peel's farthest layers over those of earlier peels.
bool LaterPeels::addBlended(GLenum mode, const Elements& elements) {
  const auto pixels = surelyWritten(peeling_.counts, peeling_.peel);
  if (peeling_.blended || !pixels || peeling_.query != GL_SAMPLES_PASSED ||
      !putsOver(p_.shadow.real, p_.shadow.rare()))
    return false;
  HeldPass pass{.outputs = outputsOf(p_.shadow),
                .viewport = peeling_.target.depths.viewport,
                .blend = HeldPass::Blend::over};
  if (pass.outputs.size() != 1 || pass.outputs[0].texture == peeling_.behind) return false;
  const Program& program = p_.shadow.program().known->program;
  pass.draws.push_back(captureProgramDraw(p_.shadow.real, program, readUniforms(p_.shadow.real, program),
                                          p_.shadow.attributes(), mode, elements));
  if (!reads(pass.draws[0], peeling_.behind) ||
      !p_.pending.presenter.layers().countPixels(p_.shadow.real, pass, peeling_.behind, peeling_.target.size,
                                                 *pixels))
    return false;
  peeling_.target.later.push_back(std::move(pass));
  peeling_.blended = true;
  return true;
}

/// Whether the current draw blends the layers that remain after the newest peel over its farthest layers.
bool LaterPeels::blendsRest() const {
  const ProgramState& program = p_.shadow.program();
  if (!peeling_.blended || p_.shadow.activeQueries > 0 || passOf(program) != Family::Pass::peelRest ||
      !putsOver(p_.shadow.real, p_.shadow.rare()) ||
      outputsOf(p_.shadow) != peeling_.target.later.back().outputs)
    return false;
  const GLuint input = inputTexture(p_.shadow.real, program);
  const std::vector<HeldPass::Output>& newest = newestOutputs(peeling_.target);
  return input != 0 && input != peeling_.target.result && input != peeling_.behind &&
         std::find(newest.begin(), newest.end(), HeldPass::Output{input, 0}) != newest.end();
}

bool LaterPeels::drawsNothing() {
  if (!peeling_.emptied) return false;
  const ProgramState& program = p_.shadow.program();
  const bool rest = p_.shadow.activeQueries == 0 && passOf(program) == Family::Pass::peelRest;
  if (!rest || inputTexture(p_.shadow.real, program) != peeling_.emptied) peeling_.emptied = 0;
  return peeling_.emptied != 0;
}

/// Traces the waiting image again, as `peels` peels would show it (scene::Layers::peels). If that fails,
/// returns false, and nothing waits any more.
bool LaterPeels::traceAgain(uint32_t peels) {
  if (peeling_.layers->peels == peels) return true;
  auto layers = std::make_shared<scene::Layers>(*peeling_.layers);
  layers->peels = peels;
  auto snapshot = std::make_shared<scene::Snapshot>(*peeling_.traced);
  snapshot->layers = layers;
  PresentResult result = p_.pending.presenter.layers().trace(snapshot, peeling_.target);
  if (result.outcome != PresentResult::traced) {
    held_.giveUp();
    return false;
  }
  peeling_.layers = std::move(layers);
  peeling_.traced = std::move(snapshot);
  peeling_.target.image = std::move(result.image);
  return true;
}

bool LaterPeels::clearsLater(GLbitfield mask) noexcept {
  if (!held_.asks()) return false;
  bool held = false;
  p_.failsafe.protect([&] {
    HeldPass pass{
        .outputs = outputsOf(p_.shadow), .viewport = peeling_.target.depths.viewport, .clear = glm::vec4(0)};
    const glm::ivec4 box = scissorBox(p_.shadow.real);
    const scene::Region all{0, 0, peeling_.target.size.x, peeling_.target.size.y};
    held = mask == GL_COLOR_BUFFER_BIT && p_.shadow.activeQueries == 0 && peeling_.blended &&
           !pass.outputs.empty() && contains({box.x, box.y, box.z, box.w}, all) &&
           clearsInFull(p_.shadow.real, p_.shadow.rare(), mask);
    if (!held) return held_.giveUp();
    p_.shadow.real.GetFloatv(GL_COLOR_CLEAR_VALUE, &pass.clear->x);
    peeling_.target.later.push_back(std::move(pass));
  });
  return held;
}

void LaterPeels::queryBegins(GLenum target, GLuint name) {
  if (held_.holdsDepths()) return held_.giveUp();
  if (!held_.asks()) return;
  if (p_.shadow.activeQueries > 0) return held_.giveUp();
  peeling_.query = target, peeling_.queryName = name;
  if (showsAll(peeling_.peel, peeling_.counts, peeling_.target.opaqueDepths.size())) {
    // The image was traced for fewer peels than the program has drawn: trace all layers.
    if (peeling_.layers->peels >= peeling_.peel || traceAgain(0)) showWaiting();
  } else if (!surelyWritten(peeling_.counts, peeling_.peel))
    held_.giveUp();
}

/// Shows the waiting image, because the program has drawn enough peels to show all layers, or is about to
/// draw the remaining ones. Returns false if the real OpenGL drew everything.
bool LaterPeels::showWaiting() {
  peeling_.stage = Peeling::Stage::none;
  p_.cleared.forget();
  const PresentResult result =
      p_.pending.presenter.layers().present(p_.shadow.real, nullptr, peeling_.target, false);
  if (result.pendingError != GL_NO_ERROR) p_.shadow.errors.set(result.pendingError);
  const bool shown = result.outcome == PresentResult::traced;
  if (shown) {
    peeling_.pauses.succeeded(peeling_.pass);
  } else {
    if (peeling_.traced) p_.counts.asRasterised(*peeling_.traced, Reason::programPass);
    held_.countHeld();
    p_.pending.withdrawPeeled();
    p_.failsafe.fail(result.loss(),
                     result.why.empty() ? "traced layers could not be shown" : result.why.c_str());
  }
  held_.end();
  return shown;
}

}  // namespace gluray::gl
