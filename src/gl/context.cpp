#include "gl/context.h"

#include "base/clock.h"
#include "base/log.h"
#include "base/timeline.h"
#include "gl/list.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <tbb/info.h>

#include <algorithm>

namespace gluray::gl {

thread_local ThreadState t_thread __attribute__((tls_model("initial-exec")));

namespace {

/// Interception alone is priced with everything held back, and what the real OpenGL does not give is not to
/// come and go.
Engine engineOf(const ContextInfo& info) {
  const bool choice = !info.off && info.settings.renderer != Renderer::null && info.settings.spp == 1;
  return choice || info.settings.engine == Engine::never ? info.settings.engine : Engine::always;
}

int threadsOf(const Settings& settings) {
  if (settings.threads > 0) return settings.threads;
  return settings.engine == Engine::automatic ? tbb::info::default_concurrency() : 1;
}

}  // namespace

std::shared_ptr<Context> Context::create(const RealGl& real, std::shared_ptr<ShareGroup> group,
                                         const ContextInfo& info, Presenter& presenter) {
  return std::shared_ptr<Context>(new Context(real, std::move(group), info, presenter));
}

Context::Context(const RealGl& realGl, std::shared_ptr<ShareGroup> group, const ContextInfo& info,
                 Presenter& presenter)
    : real(realGl),
      attachments(group->deletedBuffers),
      group_(std::move(group)),
      info_(info),
      presenter_(presenter),
      passthrough_(info.off),
      choice_(engineOf(info), threadsOf(info.settings), info.clock),
      direct_(!passthrough_ && choice_.way() == EngineChoice::Way::direct),
      latch_(info.settings.quirks.has(Quirk::materialLatch)),
      unknownCalls_(kCommandCount) {
  ++group_->contexts;
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
  attention = passthrough_ || insideBegin() || runOpen_ || compiling();
  const bool captured = !passthrough_ && (runOpen_ || compiling());
  t_thread.stream = captured ? &stream_ : nullptr;
  t_thread.direct = !captured && (passthrough_ || direct_) ? &real : nullptr;
}

Gate Context::gate(bool anywhere) noexcept {
  if (passthrough_) return Gate::forward;
  if (anywhere) return compiling() && !insideBegin() ? Gate::compile : Gate::run;
  if (insideBegin()) {
    if (compiling() && !executing()) return Gate::compile;  // no glBegin has been executed
    if (inside_ == Inside::rasterised && !openFragment_) {
      // The real OpenGL refuses it, in its turn among other errors.
      touch(kAllGroups);
      return Gate::forward;
    }
    setError(GL_INVALID_OPERATION);
    return Gate::refuse;
  }
  // A command that is not compiled leaves the run of a list open only if it cannot look at what the run has
  // set.
  if (runOpen_ || (compiling() && executing())) protect([&] { closeRun(); });
  return compiling() ? Gate::compile : Gate::run;
}

void Context::beforeForward(Flush how) noexcept {
  // A vertex that we cannot capture (an evaluator's, say): the real OpenGL draws the primitive, from its
  // first vertex on.
  if (inside_ == Inside::captured) protect([&] { surrenderRun(); });
  if (inside_ == Inside::captured) return;
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
  if (inside_ == Inside::rasterised && !openFragment_ && error == GL_INVALID_OPERATION)
    return real.Begin(GL_POINTS);
  // Between its glBegin and glEnd the real OpenGL cannot be asked.
  const GLenum older = inside_ == Inside::rasterised ? GLenum{GL_NO_ERROR} : real.GetError();
  error_ = older != GL_NO_ERROR ? older : error;
}

void Context::misuse(GLenum error) {
  if (!compiling() || executing())
    setError(error);
  else if (misused_ == GL_NO_ERROR)
    misused_ = error;
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
  if (!state.rare.asked) state.rare = readRareState(real);
  state.rare.fixedFunction = !info_.core;
  if (stale & kCurrent) readCurrent();
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
    latch_.drawn();
  } else if (stale & kCurrent) {
    latch_.restore(real);
  }
  if (stale & kFixedTextures) textures_.read(real, state);
  if (stale & kClip) readClipPlanes(real, state);
  if (stale & kTarget) readTarget(real, group_->deletedRenderbuffers, state);
  if (stale & kFixedArrays) readArrays(real, *group_, arrays), attachments.check(arrays);
  if (stale & (kProgram | kProgramTextures)) readCurrentProgram();
  if (stale & kAttributes) {
    readAttributes(real, *group_, state.program.known.get(), attributes);
    attachments.check(attributes);
  }
  while (real.GetError() != GL_NO_ERROR) {}
  dirty &= ~stale;
}

namespace {

/// State groups that an attribute group of glPushAttrib holds.
uint32_t groupsOfAttrib(GLbitfield mask) {
  if (mask == GL_ALL_ATTRIB_BITS) return kAttribGroups;
  uint32_t groups = 0;
  if (mask & GL_CURRENT_BIT) groups |= kCurrent | kMaterial;
  if (mask & GL_LIGHTING_BIT) groups |= kLighting | kMaterial;
  if (mask & GL_ENABLE_BIT) groups |= kRaster | kLighting | kMaterial | kTexture | kClip;
  if (mask & GL_TRANSFORM_BIT) groups |= kLighting | kClip | kRaster;  // depth clamp
  if (mask & GL_VIEWPORT_BIT) groups |= kViewport;
  if (mask & GL_SCISSOR_BIT) groups |= kViewport | kRaster;
  if (mask & GL_TEXTURE_BIT) groups |= kTexture;
  if (mask & GL_FOG_BIT) groups |= kRaster | kLighting;  // colour sum
  if (mask & GL_COLOR_BUFFER_BIT) groups |= kRaster | kTarget;
  if (mask & (GL_POLYGON_BIT | GL_POLYGON_STIPPLE_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT |
              GL_MULTISAMPLE_BIT))
    groups |= kRaster;
  return groups;
}

}  // namespace

void Context::pushAttrib(GLbitfield mask) {
  syncCurrent();
  real.PushAttrib(mask);
  if (deepestAttrib_ == 0) real.GetIntegerv(GL_MAX_ATTRIB_STACK_DEPTH, &deepestAttrib_);
  if (attribStack_.size() >= static_cast<size_t>(deepestAttrib_)) return;  // the real one refused, too
  attribStack_.push_back({mask, listBase});
}

void Context::popAttrib() {
  const bool sent = currentDirty_ != 0;
  syncCurrent();
  if (!attribStack_.empty()) {
    const SavedAttrib saved = attribStack_.back();
    attribStack_.pop_back();
    // Mesa 22.3 leaves what was sent after its last vertex current, unless it is asked; the draws that stood
    // in between were held back.
    float asked[4];
    if (sent && (saved.mask & GL_CURRENT_BIT)) real.GetFloatv(GL_CURRENT_COLOR, asked);
    if (saved.mask & GL_LIST_BIT) listBase = saved.listBase;
    if (saved.mask & GL_TRANSFORM_BIT) matrixMode = 0;
    // A change of the draw buffer redirects what is pending.
    if (saved.mask & GL_COLOR_BUFFER_BIT) flush();
    touch(groupsOfAttrib(saved.mask));
  }
  real.PopAttrib();
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
    if (runOpen_) closeRun();
    syncCurrent();
    flush();
  });
  forgetClear();
  if (t_thread.context == this) t_thread = {};
}

void Context::beforeSwap() {
  protect([&] {
    if (runOpen_) closeRun();
    settleShown();
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
  forgetOld();
}

void Context::forgetOld() {
  passes_.clear();
  clears_ = 0;
  workForgotten_ = work();
  group_->meshes.advance();
  deleteDiscarded();
}

void Context::cleared(GLbitfield mask) {
  if (mask & GL_DEPTH_BUFFER_BIT) passes_.clear();
  noteClear(mask);
  constexpr GLbitfield kWhole = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT;
  if ((mask & kWhole) != kWhole || work() == workForgotten_) return;
  const int patience = statistics.frames > 0 ? 64 : 4;
  if (++clears_ >= patience) forgetOld();
}

void Context::deleteDiscarded() {
  const SharedNames names = group_->takeDiscarded();
  for (const GLuint id : names.lists) real.DeleteLists(id, 1);
  for (const GLuint id : names.programs) real.DeleteProgram(id);
  if (!names.textures.empty())
    real.DeleteTextures(static_cast<GLsizei>(names.textures.size()), names.textures.data());
}

bool Context::canTrace() {
  if (!supportKnown_) {
    supportKnown_ = true;
    std::string why;
    supported_ = presenter_.supports(real, info_.core, why);
    if (!supported_)
      log::once(log::Level::warning, "support",
                "this OpenGL cannot show traced pictures (" + why + "): the program draws as without GLuRay");
  }
  return supported_;
}

void Context::present(bool rasterise) {
  showLagged();
  if (batch_.empty()) return;
  timeline::writeIfDue();
  const timeline::Span span("batch", batch_.waiting().instances.size());
  const BatchKey key = batch_.key();
  const bool peeled = key.layers == BatchKey::Layers::peeled;
  if (peeled && !layersHaveSurfaces()) return giveUpLayers();
  const scene::SnapshotPtr snapshot = batch_.take();
  const double start = kinds() ? nowSeconds() : 0;
  syncCurrent();
  passes_.flushed(rasterise ? nullptr : snapshot);
  if (rasterise) countAsRasterised(*snapshot);
  const std::optional<ClearedTarget> under = rasterise ? std::nullopt : clearedUnder(*snapshot, key);
  const Smooth smooth = smooth_;
  forgetClear();
  const PresentResult result = peeled ? presentLayers(snapshot, key)
                                      : presenter_.present(real, snapshot,
                                                           {.depthFunc = key.depthFunc,
                                                            .core = info_.core,
                                                            .rasterise = rasterise,
                                                            .programDraws = batch_.takeProgramDraws(),
                                                            .mayRepeat = !choice_.wantsStop(),
                                                            .cleared = under});
  if (result.averages) {
    smooth_ = smooth;
    smooth_.wrote(key.framebuffer, key.drawBuffer);
  }
  unresolved_.cleared = {};
  latch_.restore(real);
  takeResult(result);
  if (kinds()) [[unlikely]]
    kinds()->exclude(nowSeconds() - start);
  const auto wanted = rasterise ? PresentResult::rasterised : PresentResult::traced;
  if (result.outcome != wanted)
    stepAside(result.why.empty() ? "the ray tracer could not make a picture" : result.why.c_str());
}

/// `known`: the picture was shown before, elsewhere.
void Context::takeResult(const PresentResult& result, bool known) {
  if (result.pendingError != GL_NO_ERROR) setError(result.pendingError);
  statistics.presentSeconds += result.presentSeconds;
  if (!known) ++statistics.flushes;
  if (!known && result.repeated) ++statistics.repeated;
  statistics.buildSeconds += result.buildSeconds;
  statistics.traceSeconds += result.traceSeconds;
  statistics.blasBuilds += result.blasBuilds;
  statistics.blasRefinements += result.blasRefinements;
  if (known && result.repeated) return;
  if (!result.repeated) statistics.bvhBytes = result.bvhBytes;  // nobody asked for a known picture
  statistics.blasRefining = result.blasRefining;
}

void Context::imagesChange() noexcept {
  const bool shown = shown_.waiting && readImages(shown_.waiting->draws);
  const bool lags = lagged_ && readImages(lagged_->draws);
  if (batch_.readsImages() || unresolved_.waiting || shown || lags) protect([&] { flush(); });
}

void Context::contentsChange(GLuint buffer) noexcept {
  const bool waits = unresolved_.waiting && readsBuffer(unresolved_.waiting->draws, buffer);
  const bool shown = shown_.waiting && readsBuffer(shown_.waiting->draws, buffer);
  const bool lags = lagged_ && readsBuffer(lagged_->draws, buffer);
  if (waits || shown || lags || batch_.readsBuffer(buffer)) protect([&] { flush(); });
}

void Context::showIfVisible() {
  syncCurrent();
  if (unresolved_.waiting && group_->contexts > 1) protect([&] { settle(); });
  if (batch_.empty() && !info_.doubleBuffered) return showDrawn();
  if (batch_.empty()) return;
  const GLenum buffer = batch_.key().drawBuffer;
  const bool front =
      buffer == GL_FRONT || buffer == GL_FRONT_LEFT || buffer == GL_FRONT_AND_BACK || buffer == GL_LEFT;
  // What a framebuffer object holds is seen by nobody but contexts that share its images.
  const bool object = batch_.key().framebuffer != 0;
  if (object ? group_->contexts == 1 : info_.doubleBuffered && !front) return;
  flush();
  if (info_.doubleBuffered || object) return;
  completeFrame();
  if (info_.frameEnding) info_.frameEnding();
  afterSwap();
  if (info_.frameEnded) info_.frameEnded();
}

void Context::stepAside(const char* why) noexcept {
  try {
    if (!aside_)
      log::write(log::Level::warning,
                 std::string("stepping aside, the program draws as without GLuRay from here on: ") + why);
    aside_ = true;
    // What was held back is drawn by the real OpenGL, in order, so that nothing is missing from the picture.
    flush();
    if (runOpen_ || (compiling() && !stream_.empty())) surrenderRun();
  } catch (...) {  // nothing more can be done; the real OpenGL goes on without these vertices
  }
  updateAttention();
}

}  // namespace gluray::gl
