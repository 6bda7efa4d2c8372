// The program's side of the protocol (docs/control-protocol.md): answers to requests, and events. Has no
// sockets and no clock. Control thread; times in seconds, on the clock of nowSeconds().
#pragma once
#include "control/connection/connection.h"
#include "control/link/calls.h"
#include "control/link/change_requests.h"
#include "control/link/image_requests.h"
#include "control/link/observed.h"
#include "control/link/program/controlled_program.h"
#include "control/link/program/waker.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <functional>
#include <string>

namespace gluray::control {

class ProgramSide {
 public:
  static constexpr double kHelloSeconds = 5;                 // limit for the hub's hello
  static constexpr size_t kMuchWaiting = size_t{256} << 10;  // bytes waiting that make a hub slow

  /// The connection to the hub.
  struct Peer {
    std::function<void(Connection::Line line)> send;
    std::function<void(const std::string& why)> finish;
    std::function<size_t()> waiting;  // bytes not sent yet
  };
  /// `history`: the steps that can be undone; it outlives connections.
  ProgramSide(ControlledProgram& program, LiveSettings& live, const SettingsSource& source,
              SettingsHistory& history, Peer peer);

  /// Sends the hello.
  void begin(double now);
  /// Handles a message of the hub.
  void receiveMessage(const nlohmann::json& message, double now);
  void passed(double now);
  /// Time of the next call of passed(); infinity if only a message makes it necessary.
  double nextDue(double now) const;
  /// Whether the hub has sent its hello.
  bool greeted() const { return greeted_; }

 private:
  void send(const nlohmann::json& message);
  void error(const std::string& why);
  void answer(const nlohmann::json& id, nlohmann::json result);
  void greet(const std::string& type, const nlohmann::json& message);
  void carryOut(const std::string& type, const nlohmann::json& id, const nlohmann::json& message, double now);
  nlohmann::json valuesOf(const nlohmann::json* names, bool withLayers);
  void observe(const nlohmann::json& id, const nlohmann::json& message, double now);
  void call(const nlohmann::json& id, const nlohmann::json& message, double now);

  ControlledProgram& program_;
  LiveSettings& live_;
  const Peer peer_;
  Waker waker_;
  ChangeRequests changes_;
  Observed observed_;
  ImageRequests images_;
  Calls calls_;
  bool greeted_ = false;
  double helloBy_ = 0;
};

}  // namespace gluray::control
