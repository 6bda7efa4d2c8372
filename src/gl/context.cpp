#include "gl/context.h"

#include "gl/window/frame_settings.h"
#include "parallel/arena.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <exception>
#include <thread>
#include <utility>

namespace gluray::gl {

constinit thread_local ThreadState t_thread __attribute__((tls_model("initial-exec")));

namespace {

/// Large runs are welded on a second thread if the user lets us have one.
VertexStream::Welding weldingOf(const Settings& settings) {
  const unsigned threads =
      settings.threads > 0 ? static_cast<unsigned>(settings.threads) : std::thread::hardware_concurrency();
  return threads > 1 ? VertexStream::Welding::behind : VertexStream::Welding::here;
}

}  // namespace

std::shared_ptr<Context> Context::create(const RealGl& real, std::shared_ptr<ShareGroup> group,
                                         const ContextInfo& info, Presenter& presenter) {
  ContextInfo now = info;
  if (info.source) now.settings = *info.source->current();
  return std::shared_ptr<Context>(new Context(real, std::move(group), now, presenter));
}

Context::Context(const RealGl& realGl, std::shared_ptr<ShareGroup> group, const ContextInfo& info,
                 Presenter& presenter)
    : real(realGl),
      attachments(group->deletedBuffers),
      latch(info.settings.quirks.has(Quirk::materialLatch) && MaterialLatch::isIn(realGl)),
      immediate(*this, weldingOf(info.settings)),
      lists(*this),
      attribStack(*this),
      layers(*this),
      resolves(*this),
      window(*this),
      programs(*this),
      group_(std::move(group)),
      info_(info),
      settings_(info.settings),
      presenter_(presenter),
      passthrough_(info.off),
      choice_(engineOf(info, info.settings), threadsOf(info.settings), info.clock),
      direct_(!passthrough_ && choice_.way() == EngineChoice::Way::direct),
      unknownCalls_(kCommandCount) {
  ++group_->contexts;
  setSharedThreads(info.settings.threads);
  updateAttention();
}

Context::~Context() {
  --group_->contexts;
  try {
    group_->discard(presenter_.takeNames());
  } catch (const std::exception&) {}  // they live as long as the group
  presenter_.forget(real);
  if (t_thread.context == this) t_thread = {};
}

void Context::updateAttention() {
  attention = passthrough_ || insideBegin() || immediate.runOpen() || compiling();
  const bool captured = !passthrough_ && (immediate.runOpen() || compiling());
  t_thread.stream = captured ? &immediate.stream() : nullptr;
  t_thread.direct = !captured && (passthrough_ || direct_) ? &real : nullptr;
}

Gate Context::gate(bool anywhere, bool compiled) noexcept {
  if (passthrough_) return Gate::forward;
  if (anywhere) return compiling() && !insideBegin() ? Gate::compile : Gate::run;
  if (insideBegin()) {
    if (compiling() && !executing()) return Gate::compile;  // no glBegin has been executed
    if (immediate.realInsideBegin()) {
      // The real OpenGL refuses it, in its turn among other errors.
      touch(kAllGroups);
      return Gate::forward;
    }
    compiled ? lists.misuse() : setError(GL_INVALID_OPERATION);
    return Gate::refuse;
  }
  // A command that is not compiled leaves the run of a list open only if it cannot look at what the run has
  // set.
  if (immediate.runOpen() || (compiling() && executing())) protect([&] { immediate.closeRun(); });
  return compiling() ? Gate::compile : Gate::run;
}

void Context::beforeForward(Flush how) noexcept {
  // A vertex that we cannot capture (an evaluator's, say): the real OpenGL draws the primitive, from its
  // first vertex on.
  if (immediate.inside() == Immediate::Inside::captured) protect([&] { immediate.surrender(); });
  if (immediate.inside() == Immediate::Inside::captured) return;
  updateAttention();
  syncCurrent();
  if (how == Flush::none) return;
  protect([&] {
    if (how == Flush::look) return flush(), sendBuffers();
    switch (how) {
      case Flush::leave: leave(); break;
      case Flush::redirect: redirect(); break;
      default: flush();
    }
    if (how == Flush::all) smooth_ = {};
    cleared_.reset();  // later draws may go to another buffer of the framebuffer
    sendBuffers();
  });
}

void Context::count(int command) noexcept { ++unknownCalls_[static_cast<size_t>(command)]; }

void Context::setError(GLenum error) {
  if (error_ != GL_NO_ERROR) return;
  // The real OpenGL refuses what comes inside its glBegin, this too, in its turn among other errors.
  if (immediate.realInsideBegin() && error == GL_INVALID_OPERATION) return real.Begin(GL_POINTS);
  // Between its glBegin and glEnd the real OpenGL cannot be asked.
  const bool inside = immediate.inside() == Immediate::Inside::rasterised || immediate.executedInside();
  const GLenum older = inside ? GLenum{GL_NO_ERROR} : real.GetError();
  error_ = older != GL_NO_ERROR ? older : error;
}

GLenum Context::takeError() {
  const GLenum below = real.GetError();
  return error_ != GL_NO_ERROR ? std::exchange(error_, GL_NO_ERROR) : below;
}

void Context::refresh(uint32_t groups) noexcept {
  const uint32_t stale = dirty & (info_.core ? groups & ~kFixedFunction : groups);
  if (stale) protect([&] { readGroups(stale); });
}

void Context::readGroups(uint32_t stale) {
  // A question that the real OpenGL refuses after all sets an error; the program must see its own only.
  if (const GLenum pending = real.GetError()) setError(pending);
  if (!state.rare.asked) {
    state.rare = readRareState(real);
    state.rare.fogsWholeSum = state.rare.fogsWholeSum && settings_.quirks.has(Quirk::fogSum);
  }
  state.rare.fixedFunction = !info_.core;
  if (stale & kCurrent) current.read(real);
  syncCurrent();
  if (stale & kModelview) readModelview(real, state);
  if (stale & kProjection) readProjection(real, state);
  if (stale & kViewport) readViewport(real, state);
  if (stale & kRaster) readRaster(real, state);
  if (stale & kLighting) readLighting(real, state);
  // Colours sent while lighting was off went into the material without our taking note.
  const bool recolored = (stale & kLighting) && state.shading.colorMaterial != scene::ColorMaterial{};
  if ((stale & kMaterial) || recolored) {
    readMaterial(real, state);
    latch.drawn();
  } else if (stale & kCurrent) {
    latch.restore(real);
  }
  if (stale & kFixedTextures) textures_.read(real, state);
  if (stale & kClip) readClipPlanes(real, state);
  if (stale & kTarget) readTarget(real, group_->deletedRenderbuffers, state);
  if (stale & kFixedArrays) readArrays(real, *group_, arrays), attachments.check(arrays);
  if (stale & (kProgram | kProgramTextures)) programs.read();
  if (stale & kAttributes) {
    readAttributes(real, *group_, state.program.known.get(), attributes);
    attachments.check(attributes);
  }
  while (real.GetError() != GL_NO_ERROR) {}
  dirty &= ~stale;
}

void Context::sendBuffers() {
  const auto send = [&](const std::shared_ptr<Buffer>& buffer) {
    if (buffer) buffer->sendTo(real);
  };
  if (!group_->anyBuffersHeldBack()) return;
  refresh(kRaster);
  const bool program = state.raster.program != 0 || info_.core;
  refresh(program ? kProgram | kAttributes : uint32_t{kFixedArrays});
  const ArrayState& used = program ? attributes : arrays;
  used.forEach([&](const ArraySource& source) { send(source.buffer); });
  for (const ArraySource& source : used.generic) send(source.buffer);
  send(used.elements);
  // Fixed-function arrays may feed programs that use built-in attributes.
  if (program && info_.core) return;
  if (program) refresh(kFixedArrays);
  if (program) arrays.forEach([&](const ArraySource& source) { send(source.buffer); });
  if (!arrays.others || program) return;
  for (const auto& buffer : group_->buffers.all()) send(buffer);
}

void Context::makeCurrent() {
  t_thread.context = this;
  dirty = kAllGroups;  // another thread or another drawable may be behind it now
  drawableSize_ = {0, 0};
  updateAttention();
}

void Context::loseCurrent() {
  protect([&] {
    immediate.closeRunIfOpen();
    syncCurrent();
    flush();
  });
  forgetClear();
  if (t_thread.context == this) t_thread = {};
}

void Context::beforeSwap() {
  protect([&] {
    immediate.closeRunIfOpen();
    window.settle();
    flushBatch();  // what waits for being resolved is not in the window
  });
}

void Context::afterSwap() {
  forgetClear();  // nobody knows what the back buffer holds
  ++statistics.frames;
  if (direct_) ++statistics.framesDirect;
  beganSeconds = 0;
  chooseEngine();
  ++frame;
  begun_ = false, drawsBefore_ = draws();
  protect([&] { takeSettings(); });
  passes.clear();
  sheets.clear();
  forgetOld();
}

void Context::forgetOld() {
  clears_ = 0;
  workForgotten_ = work();
  group_->meshes.advance();
  deleteDiscarded();
}

void Context::cleared(GLbitfield mask) {
  if (mask & GL_DEPTH_BUFFER_BIT) {
    if (passes.anyByProgram()) refresh(kTarget);
    passes.clear(state.target.framebuffer), sheets.clear();
  }
  noteClear(mask);
  constexpr GLbitfield kWhole = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT;
  if ((mask & kWhole) != kWhole || work() == workForgotten_) return;
  const int patience = statistics.frames > 0 ? 64 : 4;
  if (++clears_ < patience) return;
  forgetOld();
  if (statistics.frames == 0) protect([&] { takeSettings(); });
  passes.forgetMany();  // those of framebuffers whose depth is never cleared
}

void Context::deleteDiscarded() {
  const SharedNames names = group_->takeDiscarded();
  for (const GLuint id : names.lists) real.DeleteLists(id, 1);
  for (const GLuint id : names.programs) real.DeleteProgram(id);
  if (!names.textures.empty())
    real.DeleteTextures(static_cast<GLsizei>(names.textures.size()), names.textures.data());
}

}  // namespace gluray::gl
