// The engine as the program that the hub controls. Control thread.
#pragma once
#include "control/link/job.h"
#include "control/link/program/controlled_program.h"
#include "intercept/control/scene_calls.h"
#include "intercept/control/x_server.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>

namespace gluray::intercept {

class EngineProgram : public control::ControlledProgram {
 public:
  /// Construct on a thread of the program, because the program may change its environment later.
  EngineProgram();
  nlohmann::json identity() override;
  control::Figures figures() override;
  nlohmann::json state() override;
  control::Called call(const std::string& name, const nlohmann::json& arguments, nlohmann::json& value,
                       std::string& why) override;
  void wake() noexcept override;
  void tellSize(bool wider) noexcept override;
  void wantImage(control::Wanted wanted) noexcept override;
  std::unique_ptr<control::KeptImage> takeImage() noexcept override;
  void linkBegan(bool here) noexcept override;
  void linkEnded() noexcept override;

 private:
  nlohmann::json windows();
  glm::ivec2 windowSize();

  const std::string name_;
  const control::Job job_;
  XServers servers_;
  nlohmann::json windows_;                // the last list of windows
  double listed_ = 0;                     // when it was made
  uint64_t passes_ = 0, idlePasses_ = 0;  // at the last query of the state
  bool idle_ = false;                     // the last passes were made while the program was idle
  SceneCalls sceneCalls_{[this] { return windowSize(); }};
};

}  // namespace gluray::intercept
