// The contexts of the process and what belongs to each. Private to contexts.cpp, frames.cpp and totals.cpp.
#pragma once
#include "base/log.h"
#include "gl/context.h"
#include "intercept/contexts.h"
#include "intercept/make_presenter.h"
#include "intercept/present/read_back/frame_picture.h"
#include "intercept/reports/hud.h"
#include "intercept/windows/lag.h"
#include "intercept/windows/present_without_swap.h"

#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace gluray::intercept {

using Key = std::pair<Api, const void*>;

struct Record {
  std::shared_ptr<gl::ShareGroup> group;
  std::unique_ptr<gl::Presenter> presenter;        // outlives the context, which uses it
  std::unique_ptr<present::FramePicture> picture;  // where pictures are wanted; outlives the context, too
  std::unique_ptr<Hud> hud;                        // where one is wanted
  LagPtr lag;                                      // where frames may lag
  WindowOfContext window;
  std::shared_ptr<gl::Context> context;  // null until first current, or where it could not be made
  bool tried = false;
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
};
/// What is current in the calling thread.
Current& current();

/// Runs `body`; a failure of ours costs this thread its context: the program goes on with the real OpenGL.
template <class F>
void guarded(const char* what, F&& body) noexcept {
  if (isForkedChild()) return;
  try {
    body();
  } catch (const std::exception& e) {
    log::once(log::Level::error, what, std::string(what) + ": " + e.what());
  } catch (...) { log::once(log::Level::error, what, what); }
}

/// Adds what the record's context did. The registry is locked.
void addTo(Totals& sum, const Record& record);

// frames.cpp
/// What `gluray explain` wants of the context.
void addExplaining(Record& record, gl::ContextInfo& info);
/// What is to be done with each traced picture of the context, if anything.
present::Written noteWritten(const Record& record);

}  // namespace gluray::intercept
