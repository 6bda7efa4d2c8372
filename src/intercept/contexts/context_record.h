// Registry of the process's contexts and their state, for this folder and for code that acts on the current
// context when frames end (frames/).
#pragma once
#include "gl/context/context.h"
#include "intercept/contexts/captured_pixels.h"
#include "intercept/contexts/contexts.h"
#include "intercept/hud/hud.h"
#include "intercept/present/read_back/frame_image.h"
#include "intercept/tracing/make_presenter.h"
#include "intercept/windows/idle_window_of_context.h"
#include "intercept/windows/lag.h"
#include "intercept/windows/window_of_context.h"

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

namespace gluray::intercept {

using Key = std::pair<Api, const void*>;

struct Record {
  std::shared_ptr<gl::ShareGroup> group;
  std::unique_ptr<gl::Presenter> presenter;    // must outlive the context, which uses it
  std::unique_ptr<present::FrameImage> image;  // if images are requested; must outlive the context
  std::unique_ptr<Hud> hud;                    // if requested
  std::optional<present::Features> features;   // read when an image is kept for the first time
  std::unique_ptr<CapturedPixels> captured;    // of a frame that is about to be shown, if it is wanted
  std::unique_ptr<Lag> lag;                    // if frames may lag
  WindowOfContext window;
  IdleWindowOfContext idle;
  std::shared_ptr<gl::Context> context;  // null until first current, or if creation failed
  bool tried = false;
  std::optional<uintptr_t> asked;  // the last drawable that was tested for a back buffer
  const void* display = nullptr;
  std::string vendor, renderer, version;
  Api api = Api::glx;

  ~Record();
};

struct Registry {
  std::mutex mutex;
  std::map<Key, std::shared_ptr<Record>> records;
  Totals dead;
};
/// Never destroyed: programs call OpenGL while they exit.
Registry& registry();

struct Current {
  std::shared_ptr<Record> record;
  Key key{};
  Drawables drawables;
  AskSize size;
  AskShown shown;
};
/// The calling thread's current context and drawables.
Current& current();

/// Adds the statistics of the record's context. Requires that the registry is locked.
void addTo(Totals& sum, const Record& record);

/// Is told about new contexts, on the thread in which they are current.
class ContextWatcher {
 public:
  virtual ~ContextWatcher() = default;
  /// The record's context is about to be created: sets in `info` and in the record what to record.
  virtual void making(Record& record, gl::ContextInfo& info) = 0;
  /// The context was created, or creation failed. No lock is held.
  virtual void made() noexcept = 0;
};
/// Call before the first context is created. The watcher must never be destroyed.
void watchContexts(ContextWatcher& watcher) noexcept;

}  // namespace gluray::intercept
