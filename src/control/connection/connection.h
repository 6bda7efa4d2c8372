// One connection of the control protocol (docs/control-protocol.md): messages over a Unix socket or TCP.
// All calls and callbacks on the thread that runs the socket's io_context.
#pragma once
#include "control/descriptor.h"
#include "control/messages/message.h"

#include <asio/generic/stream_protocol.hpp>
#include <asio/io_context.hpp>
#include <asio/steady_timer.hpp>
#include <nlohmann/json_fwd.hpp>

#include <array>
#include <chrono>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <string>

namespace gluray::control {

inline constexpr size_t kMaxWaiting = size_t{4} << 20;  // limit of bytes that wait for a slow peer
inline constexpr int kMaxMessages = 2000;               // limit per second, for one peer of a hub

class Connection : public std::enable_shared_from_this<Connection> {
 public:
  using Socket = asio::generic::stream_protocol::socket;
  using Line = std::shared_ptr<const std::string>;  // including its line feed
  struct Handlers {
    std::function<void(nlohmann::json&& message)> message;
    std::function<void(const std::string& why)> closed;  // called once; why: "the other side closed it", ...
    std::function<void()> drained;  // may be empty; called when all lines have been passed to the system
  };

  /// `messagesPerSecond`: limit of messages that it reads; 0: no limit.
  explicit Connection(Socket socket, int messagesPerSecond = 0);

  /// Starts reading. The connection keeps itself alive until it closes; then it releases the handlers.
  void start(Handlers handlers);
  /// Sends a message after earlier ones. Closes the connection if more than kMaxWaiting bytes wait. Ignored
  /// if it is closed.
  void send(const nlohmann::json& message);
  void send(Line line);
  /// Number of bytes that wait to be sent.
  size_t waiting() const { return waiting_; }
  /// Closes the connection after waiting data has been sent, or after a second.
  void finish(const std::string& why);
  /// Closes the connection at once.
  void close(const std::string& why);
  bool open() const { return open_; }
  /// Descriptor of the socket; negative if it is closed.
  int descriptor() { return socket_.is_open() ? socket_.native_handle() : -1; }

 private:
  /// Runs `work`, and closes the connection if it throws.
  template <class Work>
  void guarded(Work work);
  void read();
  void consumeBytes(size_t bytes);
  void takeLines();
  void write();
  void wrote(size_t lines);

  Socket socket_;
  asio::steady_timer pause_, end_;
  Handlers handlers_;
  LineReader reader_;
  std::array<char, size_t{16} << 10> buffer_{};
  std::deque<Line> lines_;
  size_t waiting_ = 0;
  bool open_ = true, started_ = false, writing_ = false;
  std::string finishing_;  // reason for closing after all is sent; empty: it stays open
  const int most_;         // messages a second
  int taken_ = 0;          // messages read since `second_`
  std::chrono::steady_clock::time_point second_{};
};

/// A socket that owns the descriptor. Throws std::exception.
Connection::Socket socketOf(asio::io_context& io, int family, int protocol, Descriptor descriptor);

/// The message as a line that can be sent to several peers.
Connection::Line sharedLine(const nlohmann::json& message);

}  // namespace gluray::control
