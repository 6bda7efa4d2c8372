// Pictures of saved scenes, of any size: traced in bands, so that memory does not grow with them. One thread.
#pragma once
#include "frame/images/traced_images.h"
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

/// What pictures of one scene with one look know of its window: those that follow each other need not find it
/// out again. Used by one thread at a time.
struct WindowMemory {
  std::shared_ptr<const Plate> moved;  // of cameras other than the saved view's; null: not known yet
  bool exposed = false;                // the renderer knows the exposures of the saved view
};

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
  /// The settings of the picture, from those that the program had; empty: the same.
  std::function<Settings(const Settings&)> settings;
  int edgeSamples = 1;       // per pixel, at least, in pictures of other sizes than the window's
  int bandPixels = 1 << 21;  // traced together; some 68 bytes each while light is refined
  /// Makes the image of a snapshot, valid until the next call, in place of the finished one that the renderer
  /// traces; empty: that. May throw.
  std::function<const Image&(const scene::Snapshot&)> images;
  std::shared_ptr<WindowMemory> window;  // null: of this picture alone
  uint64_t look = 1;  // equal in pictures of equal settings that one renderer makes: they have one exposure

  /// Whether the camera is another one than the saved view's.
  bool movesCamera() const { return turn != 0 || (camera && !(*camera == known->camera)); }
};

class Shot {
 public:
  /// A batch as the picture shows it.
  struct Placed {
    scene::Snapshot snapshot;
    scene::SnapshotPtr saved;  // as the scene has it
    DepthTest test;
    std::vector<scene::Region> cleared;  // pixels of the picture
    // Of layers: depths of opaque surfaces that the real OpenGL drew in the window, one per pixel of
    // `window`, the region there; negative: none.
    std::vector<float> rasterised;
    scene::Region window;
  };

  /// Throws std::runtime_error with one line if no picture
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
  /// The same as displayed values of floats, which are not rounded. What the real OpenGL drew, and what is
  /// blended in the order of drawing, has the values of bytes.
  enum class Range : bool {
    limited,  // samples are 0 .. 1, as in the window
    open      // light may be brighter
  };
  std::vector<glm::vec4> wideBand(int number, Range range);
  /// The pixels of a band; the lowest row of the picture is 0.
  scene::Region regionOf(int band) const;
  /// All batches, in the order of drawing.
  const std::vector<Placed>& placed() const { return placed_; }
  /// Whether a snapshot that is traced shows the window with the settings that the program had, which are not
  /// those of the picture.
  static bool isOfProgram(const scene::Snapshot& s) { return (s.view & kProgramView) != 0; }
  /// What is not as in the program; a line each.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  // Of the numbers of views as the program showed them: one exposure holds for all bands, and all turns, of a
  // picture, whatever exposure the program had.
  static constexpr uint64_t kProgramView = uint64_t{1} << 63;

  void look();
  std::vector<scene::SnapshotPtr> views() const;
  Placed placedIn(const ShotFrame& frame, const SavedBatch& batch) const;
  void place(const SavedBatch& batch);
  void lookAtWindow();
  enum class WindowLook : bool { picture, program };
  Canvas windowOf(const std::vector<SavedBatch>& batches, WindowLook look);
  const Image& traced(const scene::Snapshot& s, std::optional<frame::TracedImages>& images) const;
  void draw(Placed& placed, const scene::Region& band, Canvas& canvas) const;
  scene::Snapshot partOf(const Placed& placed, const scene::Region& part, const Canvas& canvas) const;
  /// Draws a band. `start` makes the canvas of a region and what stands behind surfaces there; `background`
  /// gives that at a place of the window.
  template <class Color, class Background, class Start>
  Canvas drawn(const scene::Region& band, const Background& background, const Start& start);
  template <class Color, class Overlay>
  std::vector<Color> rowsOf(const scene::Region& band, const Canvas& canvas, const std::vector<Color>& colors,
                            const Overlay& overlay) const;
  void note(const std::string& text);
  bool knowsWindow() const {
    return scene_.shown.width == scene_.window.x && scene_.shown.height == scene_.window.y;
  }
  /// Whether the picture is what the window shows, pixel for pixel.
  bool showsWindow() const { return frame_->isWindow() && !options_.movesCamera() && options_.overlays; }

  SavedScene scene_;
  std::vector<SavedBatch> batches_;  // those of the scene with the settings of the picture
  ShotOptions options_;
  std::unique_ptr<ShotFrame> frame_;
  frame::Renderer& renderer_;
  std::vector<Placed> placed_;
  std::shared_ptr<const Plate> plate_;  // never null
  int bandRows_ = 0, margin_ = 0, samples_ = 1;
  std::vector<std::string> notes_;
};

}  // namespace gluray::saved
