// A saved scene in the engine's library (saved/program/view.h). One thread at a time.
#pragma once
#include "saved/program/view.h"

#include <string>

namespace gluray::panel {

/// Loads the library, opens the scene, and closes it. Other calls of the library go through `library`.
class EngineView {
 public:
  struct Library {
    decltype(&glurayViewOpen) open;
    decltype(&glurayViewClose) close;
    decltype(&glurayViewShow) show;
    decltype(&glurayViewPoint) point;
  };

  /// Throws std::runtime_error with one line.
  EngineView(const std::string& libraryFile, const std::string& scene);
  ~EngineView();
  EngineView(const EngineView&) = delete;
  EngineView& operator=(const EngineView&) = delete;

  const GlurayViewFacts& facts() const { return facts_; }
  /// As glurayViewShow(). False: stopped, or failed with one line in `why`.
  bool show(const GlurayViewRequest& request, const GlurayViewSink& sink, std::string& why);
  bool point(const GlurayViewRequest& request, int x, int y, double (&at)[3]);

 private:
  Library library_{};
  GlurayView* view_ = nullptr;
  GlurayViewFacts facts_{};
};

}  // namespace gluray::panel
