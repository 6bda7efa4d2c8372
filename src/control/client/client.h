// A client of the hub (docs/control-protocol.md) for commands: sends a request, waits for its answer. Blocks,
// always for a limited time. All calls on one thread, which runs the io_context meanwhile: a HubServer of the
// same io_context goes on.
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

inline constexpr size_t kMaxEvents = 1000;  // that wait for awaitEvent(); older ones are lost

class Client {
 public:
  /// What the hub answered, or one line that says why it did not.
  struct Answer {
    nlohmann::json message;  // with a list `results` or `programs`; null if `why` says something
    std::string why;
    bool sent = false;  // the hub may have carried it out
  };

  explicit Client(asio::io_context& io);
  ~Client();

  /// Connects and exchanges hellos. Returns one line that says why it cannot; empty: it is connected.
  std::string connect(const HubAddress& address, double seconds);
  /// Whether something listened when it connected last, hub or not.
  bool reached() const { return reached_; }
  /// Whether the other side closed the connection.
  bool ended() const { return ended_; }
  /// What the hub's hello says: seconds since it began, and how many programs it expects. A hub that does not
  /// say so is old, and expects none.
  double hubAge() const { return hubAge_; }
  int64_t hubExpects() const { return hubExpects_; }
  /// Whether programs of other machines may come, which the hub cannot expect.
  bool hubListensOnTcp() const { return hubListensOnTcp_; }
  /// Ends the connection.
  void leave() { close("the client has left"); }
  /// The answer to a request, which gets an id. Events that arrive meanwhile wait for awaitEvent().
  Answer ask(nlohmann::json request, double seconds);
  /// The next event; null: none came in that time, or the connection has ended, or interrupt() was called.
  nlohmann::json awaitEvent(double seconds);
  /// Makes awaitEvent() return; for handlers that the io_context runs.
  void interrupt() { interrupted_ = true; }
  /// Empty while it is connected, otherwise one line that says why it is not.
  const std::string& whyClosed() const { return whyClosed_; }

 private:
  static constexpr double kOld = 1e9;  // seconds
  void receiveMessage(nlohmann::json&& message);
  void takeHello(const nlohmann::json& message);
  void start(std::shared_ptr<Connection> connection);
  void close(const std::string& why);
  /// Runs the io_context until done() or the time is over. Returns done().
  bool wait(double seconds, const std::function<bool()>& done);

  asio::io_context& io_;
  std::shared_ptr<Connection> connection_;
  std::shared_ptr<Client*> self_;  // handlers hold it; null once the client is gone
  std::deque<nlohmann::json> events_;
  int attempts_ = 0;      // to connect
  int64_t asked_ = 0;     // id of the last request
  bool waiting_ = false;  // for its answer
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
