// Calls about the program's scene (docs/control-protocol.md): objects, pick, highlight, lights, cameras.
// Control thread.
#pragma once
#include "control/link/program/controlled_program.h"
#include "gl/objects/shown_frames.h"
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
  static constexpr double kRemembered = 60;  // seconds after the last call
  // Seconds after the first call: a frame without surfaces may be one that shows an old image, and one
  // whose end is not known may not be whole.
  static constexpr double kDoubt = 2;
  static constexpr double kWhole = 0.1;  // seconds without another batch

  /// `windowSize`: of the window that showed a frame last, in pixels; {0, 0}: not known.
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
  gl::ShownFramePtr shownFrame();
  void list(const Frames& frames);

  const std::function<glm::ivec2()> windowSize_;
  std::vector<std::weak_ptr<const gl::ShownFrame>> listed_;  // whose objects are `list_`
  std::vector<nlohmann::json> list_;                         // in the order of their numbers
  size_t hash_ = 0;                                          // of the list without bounds
  uint64_t version_ = 0;
  double began_ = 0;  // when frames were kept first, without a pause since
};

}  // namespace gluray::intercept
