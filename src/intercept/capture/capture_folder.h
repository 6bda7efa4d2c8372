// The folder through which scenes go from the program to the launcher, which makes pictures of them (gluray
// run --shot). Files appear under their names when they are whole. Used by one thread at a time.
#pragma once
#include "saved/scene/saved_scene.h"

#include <cstdint>
#include <string>

namespace gluray::intercept {

class CaptureFolder {
 public:
  explicit CaptureFolder(std::string path) : path_(std::move(path)) {}

  /// Whether this process gives the scenes: the first process of the program that asks.
  bool claim();
  /// Writes the scene of a frame, or the reason why it cannot be written. Waits while the launcher has many
  /// scenes to draw.
  void add(uint64_t frame, const saved::SavedScene& scene) const;
  /// Writes how many frames the program has shown.
  void end(uint64_t frames) const;

 private:
  std::string fileOf(uint64_t frame, const char* ending) const;
  void waitForLauncher() const;
  int scenesLeft() const;

  std::string path_;
};

}  // namespace gluray::intercept
