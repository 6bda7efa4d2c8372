// A saved scene that somebody looks at: frames while the view moves, and pictures that get better while it
// rests, until they equal those of Shot. One thread.
#pragma once
#include "frame/tracing/renderer.h"
#include "saved/scene/saved_scene.h"
#include "saved/shot/derived_camera.h"
#include "saved/shot/shot.h"
#include "saved/view/growing_images.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gluray::saved {

struct ViewRequest {
  glm::ivec2 size{0};                 // pixels
  std::optional<ViewCamera> camera;   // none: the saved view, with what the program drew over it
  std::vector<std::string> settings;  // "name=value" each, in place of those of the scene
};

/// How far a picture is.
struct ViewStep {
  glm::ivec2 size{0};  // pixels
  uint32_t passes = 0;
  double noise = 0;  // infinite: not known yet; 0: none
  bool finished = false;
};

class SceneView {
 public:
  /// Whether somebody wants something else. Called by several threads.
  using Stop = std::function<bool()>;
  /// Premultiplied RGBA8, top row first.
  using Take = std::function<void(const ViewStep&, const std::vector<uint32_t>& pixels)>;

  explicit SceneView(SavedScene scene);
  ~SceneView();
  SceneView(const SceneView&) = delete;
  SceneView& operator=(const SceneView&) = delete;

  const SavedScene& scene() const { return scene_; }
  /// The camera of the saved view; none: the view cannot be moved.
  const std::optional<DerivedCamera>& camera() const { return camera_; }

  /// One frame of a moving view: one sample a pixel, few rays, and those of the frames before. Throws
  /// std::runtime_error with one line.
  void showMoving(const ViewRequest& request, const Take& take);
  /// The picture, after one pass, two, ..., and finished: then the pixels are those of a Shot with the same
  /// options. False: stopped. Throws std::runtime_error with one line.
  bool show(const ViewRequest& request, const Stop& stop, const Take& take);
  /// The point of the first surface at a place of the picture (pixels from the upper left corner), in the
  /// world of camera(). None: no surface, or one of another view.
  std::optional<glm::dvec3> pointAt(const ViewRequest& request, const glm::ivec2& pixel);

 private:
  struct Look;
  ShotOptions optionsFor(const ViewRequest& request) const;
  void takeLook(const std::vector<std::string>& settings);
  std::unique_ptr<Shot> shotOf(ShotOptions options, bool exact,
                               const std::function<const Image&(const scene::Snapshot&)>& images);

  SavedScene scene_;
  std::optional<DerivedCamera> camera_;
  frame::Renderer renderer_;
  Stop stop_;              // of the current call
  GrowingImages program_;  // the window with the settings of the program
  std::unique_ptr<Look> look_;
  uint64_t looks_ = 0;
  Image moving_;
};

}  // namespace gluray::saved
