// Calls that the program carries out. A call that needs a frame waits for one. Control thread; times in
// seconds.
#pragma once
#include "control/link/program/controlled_program.h"
#include "control/link/program/frame_wait.h"
#include "control/link/program/waker.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace gluray::control {

class Calls {
 public:
  static constexpr double kPoll = 0.004;  // interval of checks while a call waits
  static constexpr size_t kMaxWaiting = 64;

  /// Receives the result; it has `why` if the call is refused.
  using Answer = std::function<void(const nlohmann::json& id, nlohmann::json result)>;
  Calls(ControlledProgram& program, const SettingsSource& source, Waker& waker, Answer answer)
      : program_(program), source_(source), waker_(waker), answer_(std::move(answer)) {}

  void startCall(const std::string& name, const nlohmann::json& id, const nlohmann::json& arguments,
                 double now);
  /// Answers calls that are due.
  void passed(double now);
  double nextDue(double now) const;

 private:
  struct Waiting {
    std::string name;
    nlohmann::json id, arguments;
    FrameWait wait;
  };
  bool carryOut(const std::string& name, const nlohmann::json& id, const nlohmann::json& arguments,
                double now);

  ControlledProgram& program_;
  const SettingsSource& source_;
  Waker& waker_;
  const Answer answer_;
  std::vector<Waiting> waiting_;
};

}  // namespace gluray::control
