// Calls about the program's scene (docs/control-protocol.md): objects, pick, highlight, lights, cameras,
// save, saved.
// Control thread.
#pragma once
#include "control/link/program/controlled_program.h"
#include "gl/objects/shown_frames.h"
#include "intercept/control/scene_saver.h"
#include "intercept/control/shown_scene.h"

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace gluray::intercept {

class SceneCalls {
 public:
  static constexpr double kRemembered = 60;  // seconds for which frames are stored after the last call
  // Seconds after the first call in which a frame without surfaces may show an old image, and a frame whose
  // end is unknown may be incomplete.
  static constexpr double kDoubt = 2;
  static constexpr double kFirstTraced = 6;  // seconds after the first call until a traced frame is shown
  static constexpr double kWhole = 0.1;      // seconds without another batch until a frame counts as complete

  /// `windowSize`: returns the size in pixels of the window that showed a frame last; {0, 0} if unknown.
  explicit SceneCalls(std::function<glm::ivec2()> windowSize) : windowSize_(std::move(windowSize)) {}
  static bool knows(const std::string& name);
  control::Called call(const std::string& name, const nlohmann::json& arguments, nlohmann::json& value,
                       std::string& why);

 private:
  using Frames = std::vector<gl::ShownFramePtr>;
  nlohmann::json objects(const nlohmann::json& arguments, const Frames& frames);
  nlohmann::json pick(const nlohmann::json& arguments, const gl::ShownFrame& frame, size_t allViews);
  nlohmann::json highlight(const nlohmann::json& arguments, const gl::ShownFrame& frame);
  std::optional<ShownPoint> pointAt(const nlohmann::json& arguments, const std::vector<ShownView>& views);
  nlohmann::json save(const nlohmann::json& arguments, const gl::ShownFrame& frame);
  gl::ShownFramePtr shownFrame();
  void list(const Frames& frames);

  const std::function<glm::ivec2()> windowSize_;
  std::vector<std::weak_ptr<const gl::ShownFrame>> listed_;  // the frames whose objects `list_` contains
  std::vector<nlohmann::json> list_;                         // objects, in the order of their numbers
  size_t hash_ = 0;                                          // hash of the list without bounds
  uint64_t version_ = 0;
  SceneSaver saver_;
  double began_ = 0;  // start of the current time in which frames are stored
};

}  // namespace gluray::intercept
