// A client of the hub (docs/control-protocol.md) for commands: sends a request and waits for its answer.
// Blocks, but only for a limited time. All calls on one thread, which runs the io_context meanwhile, so that
// a HubServer on the same io_context continues.
#pragma once
#include "control/connection/connect.h"

#include <asio/io_context.hpp>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>

namespace gluray::control {

inline constexpr size_t kMaxEvents = 1000;  // that wait for awaitEvent(); older ones are dropped

class Client {
 public:
  /// The hub's answer, or a one-line error message.
  struct Answer {
    nlohmann::json message;  // with a list `results` or `programs`; null if `why` is set
    std::string why;
    bool sent = false;  // the hub may have carried out the request
  };

  explicit Client(asio::io_context& io);
  ~Client();

  /// Connects and exchanges hellos. Returns a one-line error message; empty on success.
  std::string connect(const HubAddress& address, double seconds);
  /// Whether the last connect() found a listening socket, of a hub or something else.
  bool reached() const { return reached_; }
  /// Whether the peer closed the connection.
  bool ended() const { return ended_; }
  /// Contents of the hub's hello: seconds since the hub started, and the number of programs that it expects.
  /// If they are missing, the hub counts as old, and as expecting no programs.
  double hubAge() const { return hubAge_; }
  int64_t hubExpects() const { return hubExpects_; }
  /// Whether programs on other machines may connect, which the hub cannot expect.
  bool hubListensOnTcp() const { return hubListensOnTcp_; }
  /// Ends the connection.
  void leave() { close("the client has left"); }
  /// Sends a request, which gets an id, and returns the answer. Events that arrive meanwhile wait for
  /// awaitEvent().
  Answer ask(nlohmann::json request, double seconds);
  /// The next event; null if none came in time, the connection has ended, or interrupt() was called.
  nlohmann::json awaitEvent(double seconds);
  /// Makes awaitEvent() return. For handlers that the io_context runs.
  void interrupt() { interrupted_ = true; }
  /// Empty while connected, otherwise a one-line error message.
  const std::string& whyClosed() const { return whyClosed_; }

 private:
  static constexpr double kOld = 1e9;  // seconds
  void receiveMessage(nlohmann::json&& message);
  void takeHello(const nlohmann::json& message);
  void start(std::shared_ptr<Connection> connection);
  void close(const std::string& why);
  /// Runs the io_context until done() holds or the time is over. Returns done().
  bool wait(double seconds, const std::function<bool()>& done);

  asio::io_context& io_;
  std::shared_ptr<Connection> connection_;
  std::shared_ptr<Client*> self_;  // handlers hold it; null once the client is gone
  std::deque<nlohmann::json> events_;
  int attempts_ = 0;      // attempts to connect
  int64_t asked_ = 0;     // id of the last request
  bool waiting_ = false;  // waiting for the answer to that request
  bool greeted_ = false;  // the hub has said hello
  bool reached_ = false;
  bool ended_ = false;
  double hubAge_ = kOld;
  int64_t hubExpects_ = 0;
  bool hubListensOnTcp_ = false;
  bool interrupted_ = false;
  Answer answer_;
  std::string whyClosed_ = "not connected";
};

}  // namespace gluray::control
