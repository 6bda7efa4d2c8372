// Registry of the process's contexts and their state. Private to contexts.cpp, frames.cpp and totals.cpp.
#pragma once
#include "base/log.h"
#include "gl/context/context.h"
#include "intercept/contexts.h"
#include "intercept/make_presenter.h"
#include "intercept/present/read_back/frame_picture.h"
#include "intercept/reports/hud.h"
#include "intercept/windows/lag.h"
#include "intercept/windows/present_without_swap.h"
#include "intercept/windows/x_idle_window.h"

#include <cstdint>
#include <exception>
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
  std::unique_ptr<gl::Presenter> presenter;        // outlives the context, which uses it
  std::unique_ptr<present::FramePicture> picture;  // if pictures are wanted; outlives the context, too
  std::unique_ptr<Hud> hud;                        // if wanted
  std::optional<present::Features> features;       // read when a picture is kept first
  LagPtr lag;                                      // if frames may lag
  WindowOfContext window;
  IdleWindowOfContext idle;
  std::shared_ptr<gl::Context> context;  // null until first current, or if it could not be made
  bool tried = false;
  std::optional<uintptr_t> asked;  // drawable for which it was asked whether it has a back buffer
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

/// Runs `body`, logs its exceptions once, and goes on. Does nothing in a forked child.
template <class F>
void guarded(const char* what, F&& body) noexcept {
  if (isForkedChild()) return;
  try {
    body();
  } catch (const std::exception& e) {
    log::once(log::Level::error, what, std::string(what) + ": " + e.what());
  } catch (...) { log::once(log::Level::error, what, what); }
}

/// Adds the statistics of the record's context. Requires that the registry is locked.
void addTo(Totals& sum, const Record& record);

// In frames.cpp:
/// Sets up the context to record what `gluray explain` needs.
void addExplaining(Record& record, gl::ContextInfo& info);
/// Callback for each traced picture of the context; may be empty.
present::Written noteWritten(const Record& record);

}  // namespace gluray::intercept
