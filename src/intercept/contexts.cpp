#include "intercept/contexts.h"

#include "base/log.h"
#include "base/timeline.h"
#include "gl/context.h"
#include "intercept/explanation.h"
#include "intercept/families.h"
#include "intercept/hud.h"
#include "intercept/make_presenter.h"
#include "intercept/orphan_gl.h"
#include "intercept/present/frame_picture.h"
#include "intercept/report.h"
#include "intercept/session.h"

#include <dlfcn.h>

#include <atomic>
#include <cstring>
#include <exception>
#include <memory>
#include <mutex>
#include <utility>

namespace gluray::intercept {
namespace {

using Key = std::pair<Api, const void*>;

struct Record {
  std::shared_ptr<gl::ShareGroup> group;
  std::unique_ptr<gl::Presenter> presenter;        // outlives the context, which uses it
  std::unique_ptr<present::FramePicture> picture;  // where pictures are wanted; outlives the context, too
  std::unique_ptr<Hud> hud;                        // where one is wanted
  std::shared_ptr<gl::Context> context;            // null until first current, or where it could not be made
  bool tried = false;
  const void* display = nullptr;
  std::string vendor, renderer, version;
  Api api = Api::glx;

  ~Record();
};

/// Never destroyed: programs call OpenGL while they exit.
struct Registry {
  std::mutex mutex;
  std::map<Key, std::shared_ptr<Record>> records;
  Totals dead;
};

Registry& registry() {
  static auto* r = new Registry;
  return *r;
}

struct Current {
  std::shared_ptr<Record> record;
  Key key{};
  Drawables drawables;
  AskSize size;
};
thread_local Current t_current;
bool g_forked = false;
std::atomic<uint64_t> g_frames{0};

void addExplained(Totals& sum, const Record& record) {
  const gl::ContextInfo& info = record.context->info();
  const gl::Statistics& s = record.context->statistics;
  if (!info.kinds) return;
  for (const auto& [kind, cost] : info.kinds->kinds()) sum.kinds[kind] += cost;
  for (const auto& [name, use] : info.kinds->targets()) sum.targets[name] += use;
  for (const auto& [known, use] : info.kinds->programs()) sum.programs[known] += use;
  constexpr const char* apis[] = {"GLX", "EGL", "OSMesa"};
  const bool es = record.version.starts_with("OpenGL ES");
  sum.list.push_back({apis[static_cast<int>(record.api)],
                      es          ? "ES"
                      : info.core ? "core"
                                  : "compatibility",
                      record.version, record.renderer, info.doubleBuffered, s.frames, s.drawsTraced,
                      s.drawsRasterised});
}

void add(Totals& sum, const Record& record) {
  if (!record.context) return;
  ++sum.contexts;
  sum.statistics += record.context->statistics;
  const auto& calls = record.context->unknownCalls();
  for (size_t i = 0; i < calls.size(); ++i)
    if (calls[i]) sum.unknownCalls[gl::kCommandNames[i].name] += calls[i];
  if (sum.renderer.empty())
    sum.vendor = record.vendor, sum.renderer = record.renderer, sum.version = record.version;
  addExplained(sum, record);
}

Record::~Record() {
  Registry& r = registry();
  const std::lock_guard lock(r.mutex);
  add(r.dead, *this);
  r.dead.statistics.blasRefining = 0;
  if (hud) group->discard(hud->takeNames());
}

/// Runs `body`; a failure of ours costs this thread its context: the program goes on with the real OpenGL.
template <class F>
void guarded(const char* what, F&& body) noexcept {
  if (g_forked) return;
  try {
    body();
  } catch (const std::exception& e) {
    log::once(log::Level::error, what, std::string(what) + ": " + e.what());
  } catch (...) { log::once(log::Level::error, what, what); }
}

std::string text(const gl::RealGl& real, GLenum name) {
  const auto* s = reinterpret_cast<const char*>(real.GetString(name));
  return s ? s : "";
}

/// What kind of context is current. Asked when it is first made current, before the program has called
/// anything.
gl::ContextInfo askInfo(const gl::RealGl& real, const std::string& version) {
  gl::ContextInfo info;
  info.settings = session().settings;
  info.families = families();
  info.drawableSize = [] { return t_current.size ? t_current.size() : glm::ivec2(0); };
  int major = 0, minor = 0;
  if (std::sscanf(version.c_str(), "%d.%d", &major, &minor) != 2)
    info.core = info.off = true;  // "OpenGL ES ..."
  GLboolean doubleBuffered = GL_TRUE;
  if (!info.core) real.GetBooleanv(GL_DOUBLEBUFFER, &doubleBuffered);
  info.doubleBuffered = doubleBuffered != GL_FALSE;
  GLint flags = 0, profile = 0;
  if (!info.core && major >= 3) real.GetIntegerv(GL_CONTEXT_FLAGS, &flags);
  if (!info.core && (major > 3 || (major == 3 && minor >= 2)))
    real.GetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
  if ((flags & GL_CONTEXT_FLAG_FORWARD_COMPATIBLE_BIT) || (profile & GL_CONTEXT_CORE_PROFILE_BIT))
    info.core = true;
  return info;
}

/// A frame has ended: counted, and told to the clock that `gluray explain` preloads.
void countFrame() noexcept {
  using Tell = void (*)();
  static const auto tell =
      reinterpret_cast<Tell>(session().explainFrames ? dlsym(RTLD_DEFAULT, "glurayFrameEnded") : nullptr);
  ++g_frames;
  if (tell) tell();
}

void endFrame() noexcept {
  countFrame();
  writeReportIfDue();
}

/// Keeps the picture of the frame that is about to be shown from `buffer` of the window.
void takePicture(Record& record, GLenum buffer) {
  if (!record.picture || !record.context) return;
  glm::ivec2 size = t_current.size ? t_current.size() : glm::ivec2(0);
  if (size.x <= 0 || size.y <= 0) {
    GLint viewport[4] = {};
    record.context->real.GetIntegerv(GL_VIEWPORT, viewport);
    size = {viewport[0] + viewport[2], viewport[1] + viewport[3]};
  }
  if (size.x > 0 && size.y > 0)
    keepPicture(record.picture->take(record.context->real, buffer, size.x, size.y, g_frames + 1));
}

/// What `gluray explain` wants of the context.
void addExplaining(Record& record, gl::ContextInfo& info) {
  if (!session().explainFrames) return;
  info.kinds = std::make_shared<gl::DrawKinds>(!info.core);
  info.frameEnded = endFrame;
  if (!session().picture || record.version.starts_with("OpenGL ES")) return;
  record.picture = std::make_unique<present::FramePicture>();
  info.frameEnding = [&record] { takePicture(record, GL_FRONT); };
}

present::Written noteWritten(const Record& record) {
  if (!record.picture) return {};
  return [picture = record.picture.get()](const gl::RealGl& real, const Image& image) {
    guarded("cannot note what was traced", [&] { picture->written(real, image); });
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
  addExplaining(record, info);
  std::unique_ptr<gl::Presenter> presenter = makePresenter(info.settings, noteWritten(record));
  std::shared_ptr<gl::Context> context = gl::Context::create(real, record.group, info, *presenter);
  const std::lock_guard lock(registry().mutex);  // another thread may be adding up for the report
  record.vendor = std::move(vendor), record.renderer = std::move(renderer),
  record.version = std::move(version);
  record.presenter = std::move(presenter);
  record.context = std::move(context);
}

/// Shows the figures over the frame that is about to be shown, where nothing of the program's would notice.
void drawHud(Record& record) {
  gl::Context& context = *record.context;
  if (context.passthrough() || context.insideBegin() || context.activeQueries > 0) return;
  GLint mode = GL_RENDER;
  if (!context.info().core) context.real.GetIntegerv(GL_RENDER_MODE, &mode);
  if (mode != GL_RENDER) return;
  if (!record.hud) record.hud = std::make_unique<Hud>(context.real);
  const GLenum pending = record.hud->draw(totals().statistics, nowSeconds());
  if (pending != GL_NO_ERROR) context.setError(pending);
}

std::shared_ptr<Record> newRecord(const Key& share) {
  auto record = std::make_shared<Record>();
  const auto it = registry().records.find(share);
  record->group =
      share.second && it != registry().records.end() ? it->second->group : std::make_shared<gl::ShareGroup>();
  return record;
}

}  // namespace

void contextCreated(Api api, const void* handle, const void* share, const void* display) noexcept {
  if (!handle) return;
  guarded("cannot follow a new context", [&] {
    std::shared_ptr<Record> old;  // destroyed outside the lock
    const std::lock_guard lock(registry().mutex);
    auto record = newRecord({api, share});
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
    if (gl::Context* context = gl::t_thread.context) context->beforeSwap();
  });
}

void leaveCurrent() noexcept {
  guarded("cannot leave a context", [] {
    if (gl::Context* context = gl::t_thread.context) context->loseCurrent();
  });
}

void textureImageBound() noexcept {
  guarded("cannot follow a texture", [] {
    gl::Context* context = gl::t_thread.context;
    if (!context) return;
    context->textures().allImagesChanged();
    context->touch(gl::kTexture);
  });
}

void stayCurrent() noexcept {
  guarded("cannot stay in a context", [] {
    if (t_current.record && t_current.record->context) t_current.record->context->makeCurrent();
  });
}

void becameCurrent(Api api, const void* handle, Drawables drawables, AskSize size) noexcept {
  guarded("this context is not ray traced", [&] {
    gl::t_thread = {};
    std::shared_ptr<Record> record;
    // Where the context cannot be followed, calls go to the OpenGL that it belongs to.
    t_orphanGl = handle ? &realGl(api) : nullptr;
    if (handle) {
      const std::lock_guard lock(registry().mutex);
      auto& slot = registry().records[{api, handle}];
      if (!slot) slot = newRecord({});  // made by a way we do not see
      record = slot;
    }
    t_current = {record, {api, handle}, drawables, std::move(size)};
    if (!record) return;
    if (!record->tried) makeContext(*record, api);
    if (record->context) record->context->makeCurrent();
  });
}

bool isCurrent(Api api, const void* handle, Drawables drawables) noexcept {
  return handle && t_current.key == Key{api, handle} && t_current.drawables == drawables;
}

void swapping(uintptr_t drawable) noexcept {
  flushCurrent();
  guarded("cannot measure a frame", [&] {
    if (gl::t_thread.context && t_current.drawables.draw == drawable) gl::t_thread.context->completeFrame();
  });
  if (!session().picture && !session().hud) return;
  if (!t_current.record || t_current.drawables.draw != drawable || !t_current.record->context ||
      !t_current.record->context->info().doubleBuffered)
    return;
  guarded("cannot take a picture", [&] {
    if (session().picture) takePicture(*t_current.record, GL_BACK);
  });
  guarded("cannot show figures", [&] {
    if (session().hud) drawHud(*t_current.record);
  });
}

void swapped(uintptr_t drawable) noexcept {
  guarded("cannot end a frame", [&] {
    gl::Context* context = gl::t_thread.context;
    // Without a back buffer a swap shows nothing new: glFlush and glFinish end frames there.
    if (context && t_current.drawables.draw == drawable && context->info().doubleBuffered)
      context->afterSwap(), countFrame(), timeline::mark("frame");
  });
  writeReportIfDue();
}

uint64_t framesEnded() noexcept { return g_frames; }

void closeKinds() noexcept {
  guarded("cannot end the explanation", [] {
    const std::lock_guard lock(registry().mutex);
    for (const auto& [key, record] : registry().records)
      if (record->context && record->context->kinds()) record->context->kinds()->close();
  });
}

void drawableGoing(uintptr_t drawable) noexcept {
  if (t_current.drawables.draw == drawable) flushCurrent();
}

void passThroughAfterFork() noexcept {
  g_forked = true;
  timeline::g_recording = false;
  gl::t_thread = {};
}

bool isForkedChild() noexcept { return g_forked; }

Totals totals() {
  Registry& r = registry();
  const std::lock_guard lock(r.mutex);
  Totals sum = r.dead;
  for (const auto& [key, record] : r.records) add(sum, *record);
  return sum;
}

}  // namespace gluray::intercept
