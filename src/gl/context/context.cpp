#include "gl/context/context.h"

#include "base/processes/process_exit.h"
#include "base/processes/usable_cores.h"
#include "parallel/arena.h"

#include <atomic>
#include <exception>

namespace gluray::gl {

constinit thread_local ThreadState t_thread __attribute__((tls_model("initial-exec")));

namespace {

std::atomic<const ThreadState*> g_firstThread{nullptr};  // of those that have made a context current
std::atomic<bool> g_usedByThreads{false};

}  // namespace

void noteThread() noexcept {
  const ThreadState* first = nullptr;
  if (g_usedByThreads || g_firstThread.compare_exchange_strong(first, &t_thread) || first == &t_thread)
    return;
  g_usedByThreads = true;
}

bool usedByThreads() noexcept { return g_usedByThreads; }

namespace {

/// Large runs are welded on a second thread if the setting `threads` allows more than one.
VertexStream::Welding weldingOf(const Settings& settings) {
  const int threads = settings.threads > 0 ? settings.threads : chosenThreadsHere();
  return threads > 1 ? VertexStream::Welding::behind : VertexStream::Welding::here;
}

}  // namespace

std::shared_ptr<Context> Context::create(const RealGl& real, std::shared_ptr<ShareGroup> group,
                                         const ContextInfo& info, Presenter& presenter) {
  return std::shared_ptr<Context>(new Context(real, std::move(group), info, presenter));
}

Context::Context(const RealGl& realGl, std::shared_ptr<ShareGroup> group, const ContextInfo& info,
                 Presenter& presenter)
    : real(realGl),
      attention(realGl, info.off, info.decisions != nullptr, immediate, lists, clock),
      errors(realGl, beginEnd),
      failsafe([this] { drawHeld(); }),
      settings(info),
      shadow(realGl, beginEnd, std::move(group), info, settings.now(), errors, failsafe),
      clock(shadow.info, settings.now()),
      counts(shadow, clock),
      cleared(shadow, clock, failsafe),
      composed({shadow, failsafe, cleared}, presenter),
      pending({shadow, failsafe, clock, counts, surfaces, cleared}, presenter),
      relighting({shadow, failsafe, clock, counts, surfaces, pending}),
      flusher({shadow, failsafe, clock, counts, surfaces, cleared, pending, layers, resolves, window,
               composed, relighting}),
      classifier({shadow, failsafe, clock, surfaces, pending, layers}),
      raster({shadow, failsafe, surfaces, cleared, pending, flusher, relighting, classifier, layers, resolves,
              window, composed}),
      filler({shadow, failsafe, clock, surfaces, pending, flusher, classifier, layers, raster}),
      draws({shadow, failsafe, counts, raster}),
      layers({shadow, failsafe, clock, counts, cleared, pending, flusher}),
      resolves({shadow, failsafe, clock, surfaces, cleared, pending, window, composed}),
      window({shadow, failsafe, clock, counts, surfaces, cleared, pending, layers}),
      passthrough({shadow, failsafe, clock, counts, cleared, flusher, window, attention, culled}),
      frames({settings, shadow, failsafe, clock, counts, surfaces, cleared, pending, flusher, relighting,
              resolves, window, passthrough, immediate, lists}),
      fullscreen({shadow, failsafe, cleared, pending, flusher, relighting, resolves}),
      volumes({shadow, failsafe, clock, surfaces, pending, relighting, raster, filler}),
      untraced(shadow, clock),
      programs({shadow, failsafe, clock, surfaces, pending, flusher, classifier, filler, raster, layers}),
      culled({shadow, failsafe, clock, counts, pending, raster, cleared}),
      immediate({beginEnd, shadow, failsafe, clock, counts, classifier, filler, raster, draws, window,
                 passthrough, lists, attention},
                weldingOf(settings.now())),
      lists({*this, shadow, failsafe, clock, immediate, attention}),
      attribStack({shadow, flusher, cleared, lists}),
      unknownCalls_(kCommandCount) {
  static std::atomic<uint64_t> contexts{0};
  shadow.setContextNumber(++contexts);
  ++shadow.group.contexts;
  setSharedThreads(settings.now().threads);
  attention.update();
}

Context::~Context() {
  --shadow.group.contexts;
  try {
    shadow.group.discard(pending.presenter.takeNames());
  } catch (const std::exception&) {}  // not deleted: they live as long as the real share group
  pending.presenter.forget(real);
  if (t_thread.context == this) t_thread = {};
}

/// After a failure: has the real OpenGL draw the pending batch and the open run, in order, so that nothing is
/// missing from the image.
void Context::drawHeld() {
  try {
    flusher.flush();
    if (immediate.runOpen() || (lists.compiling() && !immediate.stream().empty())) immediate.surrender();
  } catch (...) {  // nothing more can be done; the real OpenGL goes on without these vertices
  }
  attention.update();
}

Gate Context::gate(const char* command, bool anywhere, bool compiled) noexcept {
  if (shadow.info.decisions) [[unlikely]]
    shadow.info.decisions->command(command);
  if (shadow.info.off) return Gate::forward;
  if (!anywhere && immediate.reliesOnAnswer() && !immediate.insideBegin()) {
    immediate.forgetAnswer();
    attention.update();
  }
  if (anywhere) return lists.compiling() && !immediate.insideBegin() ? Gate::compile : Gate::run;
  if (immediate.insideBegin()) {
    if (lists.compiling() && !lists.executing()) return Gate::compile;  // no glBegin has been executed
    if (immediate.realInsideBegin()) {
      // The real OpenGL raises the error itself, in order with other errors.
      touch(kAllGroups);
      return Gate::forward;
    }
    compiled ? lists.misuse() : errors.set(GL_INVALID_OPERATION);
    return Gate::refuse;
  }
  // Close the run, whose attributes the command could read. While a list is only compiled (GL_COMPILE), the
  // list's run has set nothing and stays open.
  if (immediate.runOpen() || (lists.compiling() && lists.executing())) protect([&] { immediate.closeRun(); });
  return lists.compiling() ? Gate::compile : Gate::run;
}

void Context::prepareToForward(Flush how) noexcept {
  // A vertex that we cannot capture, for instance an evaluator's: the real OpenGL draws the whole primitive.
  if (immediate.inside() == Immediate::Inside::captured) protect([&] { immediate.surrender(); });
  if (immediate.inside() == Immediate::Inside::captured) return;
  attention.update();
  if (how == Flush::none) return;
  protect([&] {
    if (how == Flush::look) return flusher.flush(), shadow.sendBuffers();
    if (how == Flush::read) {
      const FlushPurpose reading(clock, &FrameClock::reads);
      return flusher.flush(), shadow.sendBuffers();
    }
    switch (how) {
      case Flush::leave: flusher.leave(); break;
      case Flush::redirect: flusher.redirect(); break;
      default: flusher.flush();
    }
    if (how == Flush::all) cleared.forgetAntialiased();
    cleared.forgetClear();  // later draws may go to another draw buffer of the framebuffer
    shadow.sendBuffers();
  });
}

void Context::makeCurrent(uintptr_t drawable) {
  noteThread();
  t_thread.context = this;
  shadow.madeCurrent(drawable);
  filler.forgetDrawable();
  immediate.forgetAnswer();
  attention.update();
}

void Context::loseCurrent() {
  // Nobody sees what is drawn at exit, and the real OpenGL's libraries may have destroyed their contexts and
  // static objects: not even state is read there.
  if (!isExiting()) {
    protect([&] {
      immediate.closeRunIfOpen();
      flusher.flush();
      relighting.finish(Relighting::Place::leaving);
    });
  }
  cleared.forget();
  if (t_thread.context == this) t_thread = {};
}

}  // namespace gluray::gl
