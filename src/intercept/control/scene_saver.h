// Writes a scene to a file on a thread of its own, because that may take longer than a hub waits. Control
// thread.
#pragma once
#include "base/background_job.h"
#include "saved/scene/saved_scene.h"

#include <mutex>
#include <optional>
#include <string>

namespace gluray::intercept {

class SceneSaver {
 public:
  /// Begins to write into an empty file that exists. Throws std::runtime_error with one line if another scene
  /// is being written, or no thread can be started.
  void start(saved::SavedScene scene, const std::string& file);
  /// Whether the scene that was begun last, into this file, is written; none: not yet. Throws
  /// std::runtime_error with one line if it could not be written, or was not begun.
  bool isSaved(const std::string& file);

 private:
  std::mutex mutex_;  // guards the members below
  std::string file_;
  std::optional<std::string> result_;  // why it could not be written, or empty; none: not yet
  BackgroundJob thread_;               // last member: it ends before the others are destroyed
};

}  // namespace gluray::intercept
