#include "intercept/contexts/contexts.h"

#include "base/never_destroyed.h"
#include "base/timeline.h"
#include "frame/tracing/renderer.h"
#include "gl/clock/frame_settings.h"
#include "gl/real/extensions.h"
#include "intercept/contexts/context_record.h"
#include "intercept/session/families.h"
#include "intercept/session/guarded.h"
#include "intercept/session/kept_precedents.h"
#include "intercept/session/session.h"
#include "intercept/stubs/orphan_gl.h"

#include <atomic>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <mutex>
#include <new>
#include <utility>

namespace gluray::intercept {
namespace {

std::atomic<ContextWatcher*> g_watcher{nullptr};

std::string text(const gl::RealGl& real, GLenum name) {
  const auto* s = reinterpret_cast<const char*>(real.GetString(name));
  return s ? s : "";
}

/// Properties of the current context. Queried when it is first made current, before the program's first call.
gl::ContextInfo askInfo(const gl::RealGl& real, const std::string& version) {
  gl::ContextInfo info;
  info.source = &settingsOfNow();
  info.settings = *info.source->current();
  info.families = families();
  info.drawableSize = [] { return current().size ? current().size() : glm::ivec2(0); };
  info.isShown = [] {
    // Windows that are hidden later still count as shown.
    AskShown& shown = current().shown;
    if (!shown || !shown()) return false;
    shown = [] { return true; };
    return true;
  };
  int major = 0, minor = 0;
  if (std::sscanf(version.c_str(), "%d.%d", &major, &minor) != 2) info.core = info.off = true;  // OpenGL ES
  info.version = 10 * major + minor;
  info.packedFloats = !info.off && gl::takesPackedFloats(real, info.version);
  info.software = !info.off && gl::rendersInSoftware(real);
  GLint flags = 0, profile = 0;
  if (!info.core && major >= 3) real.GetIntegerv(GL_CONTEXT_FLAGS, &flags);
  if (!info.core && (major > 3 || (major == 3 && minor >= 2)))
    real.GetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
  if ((flags & GL_CONTEXT_FLAG_FORWARD_COMPATIBLE_BIT) || (profile & GL_CONTEXT_CORE_PROFILE_BIT))
    info.core = true;
  return info;
}

/// Whether the drawable of the current context has a back buffer. Framebuffer objects have none, so the
/// window is bound for the query. Without a surface only framebuffer objects can be drawn into.
bool hasBackBuffer(const gl::Context& context, Api api, uintptr_t drawable) {
  if (drawable == 0 && api != Api::osmesa) return true;
  const gl::RealGl& real = context.real;
  GLint bound = 0;
  if (context.info().version >= 30) real.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  if (bound != 0) real.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  GLboolean doubleBuffered = GL_TRUE;
  real.GetBooleanv(GL_DOUBLEBUFFER, &doubleBuffered);
  if (bound != 0) real.BindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(bound));
  return doubleBuffered != GL_FALSE;
}

/// Call when the record's context became current: queries its back buffer if the drawable has changed.
void noteDrawable(Record& record, Api api, uintptr_t drawable) {
  gl::Context& context = *record.context;
  std::unique_lock lock(registry().mutex);  // another thread may destroy drawables or compute totals
  if (std::exchange(record.asked, drawable) == drawable || context.info().off) return;
  lock.unlock();
  const bool doubleBuffered = hasBackBuffer(context, api, drawable);
  lock.lock();
  context.setDoubleBuffered(doubleBuffered);
}

/// Callback for each traced image of the context; may be empty.
present::Written noteWritten(const Record& record) {
  if (!record.image) return {};
  return [recorder = record.image.get()](const gl::RealGl& real, const Image& image) {
    guarded("cannot note what was traced", [&] { recorder->written(real, image); });
  };
}

void makeContext(Record& record, Api api) {
  record.tried = true;
  record.api = api;
  const gl::RealGl& real = realGl(api);
  std::string vendor = text(real, GL_VENDOR), renderer = text(real, GL_RENDERER),
              version = text(real, GL_VERSION);
  gl::ContextInfo info = askInfo(real, version);
  record.version = version;
  if (!info.off && info.settings.engine == Engine::automatic)
    info.precedents = precedentsOf({renderer, gl::threadsOf(info.settings)});
  if (ContextWatcher* const watcher = g_watcher) watcher->making(record, info);
  std::unique_ptr<gl::Presenter> presenter =
      makePresenter(info.settings, noteWritten(record), api == Api::glx);
  std::shared_ptr<gl::Context> context = gl::Context::create(real, record.group, info, *presenter);
  const std::lock_guard lock(registry().mutex);  // another thread may compute the report's totals
  record.vendor = std::move(vendor), record.renderer = std::move(renderer),
  record.version = std::move(version);
  record.presenter = std::move(presenter);
  record.context = std::move(context);
}

/// The registry is locked, and a record's destructor locks it, too. So everything else is allocated before
/// the record, because allocations may throw.
std::shared_ptr<Record> newRecord(const Key& share) {
  const auto it = registry().records.find(share);
  auto group =
      share.second && it != registry().records.end() ? it->second->group : std::make_shared<gl::ShareGroup>();
  auto record = std::make_shared<Record>();
  record->group = std::move(group);
  return record;
}

}  // namespace

Registry& registry() {
  static NeverDestroyed<Registry> registry;
  return *registry;
}

namespace {

// The calling thread's Current lives in plain storage: at exit() the main thread's thread_local objects are
// destroyed before static objects of the program, whose destructors may still leave and destroy contexts.
alignas(Current) constinit thread_local std::byte t_current[sizeof(Current)]{};
constinit thread_local bool t_hasCurrent = false;

/// Destroys the thread's Current when the thread ends. Later uses get an empty one.
struct CurrentOwner {
  ~CurrentOwner() {
    if (std::exchange(t_hasCurrent, false)) std::destroy_at(reinterpret_cast<Current*>(t_current));
  }
};

}  // namespace

Current& current() {
  if (!t_hasCurrent) {
    static thread_local CurrentOwner owner;
    std::construct_at(reinterpret_cast<Current*>(t_current));
    t_hasCurrent = true;
  }
  return *std::launder(reinterpret_cast<Current*>(t_current));
}

Record::~Record() {
  Registry& r = registry();
  const std::lock_guard lock(r.mutex);
  addTo(r.dead, *this);
  r.dead.statistics.blasRefining = 0;
  if (hud) group->discard(hud->takeNames());
}

void contextCreated(Api api, const void* handle, const void* share, const void* display) noexcept {
  if (!handle) return;
  guarded("cannot follow a new context", [&] {
    std::shared_ptr<Record> old, record;  // destroyed outside the lock
    const std::lock_guard lock(registry().mutex);
    record = newRecord({api, share});
    record->display = display;
    old = std::exchange(registry().records[{api, handle}], std::move(record));
  });
}

void contextDestroyed(Api api, const void* handle) noexcept {
  guarded("cannot let go of a context", [&] {
    std::shared_ptr<Record> gone;
    const std::lock_guard lock(registry().mutex);
    const auto it = registry().records.find({api, handle});
    if (it == registry().records.end()) return;
    gone = std::move(it->second);
    registry().records.erase(it);
  });
  frame::Renderer::contextGone();
}

void displayTerminated(const void* display) noexcept {
  guarded("cannot let go of a display", [&] {
    std::map<Key, std::shared_ptr<Record>> gone;
    const std::lock_guard lock(registry().mutex);
    auto& records = registry().records;
    for (auto it = records.begin(); it != records.end();) {
      const auto next = std::next(it);
      if (it->first.first == Api::egl && it->second->display == display) gone.insert(records.extract(it));
      it = next;
    }
  });
}

void flushCurrent() noexcept {
  guarded("cannot draw what is pending", [] {
    gl::Context* context = gl::t_thread.context;
    if (!context) return;
    if (context->info().decisions) context->info().decisions->command("SwapBuffers");
    context->frames.beforeSwap();
  });
}

void leaveCurrent() noexcept {
  guarded("cannot leave a context", [] {
    gl::Context* context = gl::t_thread.context;
    if (!context) return;
    if (context->info().decisions) context->info().decisions->command("MakeCurrent");
    context->loseCurrent();
  });
}

void textureImageBound() noexcept {
  guarded("cannot follow a texture", [] {
    gl::Context* context = gl::t_thread.context;
    if (!context) return;
    context->shadow.textures.allImagesChanged();
    context->touch(gl::kTexture);
  });
}

void stayCurrent() noexcept {
  guarded("cannot stay in a context", [] {
    if (current().record && current().record->context)
      current().record->context->makeCurrent(current().drawables.draw);
  });
}

void becameCurrent(Api api, const void* handle, Drawables drawables, AskSize size, AskShown shown) noexcept {
  guarded("this context is not ray traced", [&] {
    gl::t_thread = {};
    std::shared_ptr<Record> record;
    // Calls of an unknown context go to the OpenGL that it belongs to.
    t_orphanGl = handle ? &realGl(api) : nullptr;
    if (handle) {
      const std::lock_guard lock(registry().mutex);
      const auto it = registry().records.find({api, handle});
      if (it != registry().records.end())
        record = it->second;
      else  // created without any door seeing it
        registry().records[{api, handle}] = record = newRecord({});
    }
    current() = {record, {api, handle}, drawables, std::move(size), std::move(shown)};
    if (!record) return;
    if (!record->tried) {
      makeContext(*record, api);
      if (ContextWatcher* const watcher = g_watcher) watcher->made();
    }
    if (!record->context) return;
    noteDrawable(*record, api, drawables.draw);
    record->context->makeCurrent(drawables.draw);
  });
}

bool isCurrent(Api api, const void* handle, Drawables drawables) noexcept {
  return handle && current().key == Key{api, handle} && current().drawables == drawables;
}

void drawableGoing(uintptr_t drawable) noexcept {
  if (current().drawables.draw == drawable) flushCurrent();
  // A later drawable may get the same name.
  const std::lock_guard lock(registry().mutex);
  for (auto& [key, record] : registry().records)
    if (record->asked == drawable) record->asked.reset();
}

void passThroughAfterFork() noexcept {
  noteFork();
  timeline::g_recording = false;
  gl::t_thread = {};
}

void watchContexts(ContextWatcher& watcher) noexcept { g_watcher = &watcher; }

}  // namespace gluray::intercept
