// The launcher's end of the folder through which a program gives scenes (intercept/capture/capture_folder.h).
// One thread.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

namespace gluray::launcher {

/// What the program has given about one frame.
struct CapturedFrame {
  uint64_t frame = 0;
  std::string scene;  // file; empty: it could not be saved
  std::string why;    // then one line
};

class SceneFolder {
 public:
  /// Makes the folder beside `file`, where there should be room for it. Throws std::runtime_error with one
  /// line.
  explicit SceneFolder(const std::string& file);
  /// Removes it with all that is in it.
  ~SceneFolder();
  SceneFolder(const SceneFolder&) = delete;
  SceneFolder& operator=(const SceneFolder&) = delete;

  const std::string& path() const { return path_; }
  /// The earliest frame that is there; none: none is.
  std::optional<CapturedFrame> next() const;
  void remove(const CapturedFrame& frame) const;
  /// The number of frames that the program has shown; none: it has not said so at its end.
  std::optional<uint64_t> frames() const;

 private:
  std::string path_;
  int lock_ = -1;  // says that scenes will be taken
};

}  // namespace gluray::launcher
