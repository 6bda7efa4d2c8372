// Pictures of saved scenes, of any size: traced in bands, so that memory does not grow with them. One thread.
#pragma once
#include "frame/tracing/renderer.h"
#include "saved/scene/saved_scene.h"
#include "saved/shot/canvas.h"
#include "saved/shot/path_view.h"
#include "saved/shot/plate.h"
#include "saved/shot/shot_frame.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gluray::saved {

struct ShotOptions {
  static constexpr int kLargestSide = 32768;  // pixels
  glm::ivec2 size{0};                         // pixels; {0, 0}: that of the window
  Fit fit = Fit::all;
  bool transparent = false;  // the background
  bool overlays = true;      // text, axes and widgets that the program drew
  double turn = 0;           // degrees by which the camera goes around the scene: then without overlays
  // A camera of a path, in the world of `known`, in place of a turn: also without overlays.
  std::optional<ViewCamera> camera;
  std::shared_ptr<const KnownView> known;
  int bandPixels = 1 << 21;  // traced together; some 68 bytes each while light is refined

  /// Whether the camera is another one than the saved view's.
  bool movesCamera() const { return turn != 0 || (camera && !(*camera == known->camera)); }
};

class Shot {
 public:
  /// The scene's snapshots have the wanted settings. Throws std::runtime_error with one line if no picture
  /// can be made.
  Shot(SavedScene scene, const ShotOptions& options, frame::Renderer& renderer);
  ~Shot();
  Shot(const Shot&) = delete;
  Shot& operator=(const Shot&) = delete;

  glm::ivec2 size() const { return frame_->size(); }
  /// Rows of a band, from the top of the picture on; the last may have fewer.
  int bandRows() const { return bandRows_; }
  int bands() const { return (size().y + bandRows_ - 1) / bandRows_; }
  /// Traces band `number`, 0 at the top. Premultiplied RGBA8, top row first. Throws std::runtime_error with
  /// one line.
  std::vector<uint32_t> band(int number);
  /// What is not as in the program; a line each.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  struct Placed;
  void look();
  std::vector<scene::SnapshotPtr> views() const;
  static Placed placedIn(const ShotFrame& frame, const SavedBatch& batch);
  void place(const SavedBatch& batch);
  void lookAtWindow();
  void draw(Placed& placed, const scene::Region& band, Canvas& canvas) const;
  scene::Snapshot partOf(const Placed& placed, const scene::Region& part, const Canvas& canvas) const;
  std::vector<uint32_t> behind(const scene::Region& band) const;
  void note(const std::string& text);

  SavedScene scene_;
  ShotOptions options_;
  std::unique_ptr<ShotFrame> frame_;
  frame::Renderer& renderer_;
  std::vector<Placed> placed_;
  Plate plate_;
  int bandRows_ = 0, margin_ = 0, samples_ = 1;
  std::vector<std::string> notes_;
};

}  // namespace gluray::saved
