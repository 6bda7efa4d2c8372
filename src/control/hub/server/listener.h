// Accepts connections of a listening socket. On the thread that runs the io_context.
#pragma once
#include "control/connection/connection.h"

#include <asio/io_context.hpp>
#include <asio/posix/stream_descriptor.hpp>
#include <asio/steady_timer.hpp>
#include <sys/socket.h>

#include <functional>
#include <memory>
#include <string>

namespace gluray::control {

class Listener : public std::enable_shared_from_this<Listener> {
 public:
  /// Receives a non-blocking, close-on-exec socket. `address`: the peer's IP address, empty for a Unix
  /// socket. If it throws, that connection is closed, and others are still accepted.
  using Accepted = std::function<void(Connection::Socket socket, const std::string& address)>;

  /// Takes over the listening descriptor.
  Listener(asio::io_context& io, Descriptor descriptor, Accepted accepted);
  void start() { wait(); }
  void stop();
  /// Accepts waiting connections. If there are no descriptors left, tries again after a short time.
  void accept();

 private:
  void wait();
  void handOver(Descriptor socket, const sockaddr_storage& address, socklen_t size);
  asio::io_context& io_;
  asio::posix::stream_descriptor descriptor_;
  asio::steady_timer pause_;
  Accepted accepted_;
};

/// Listens on "HOST:PORT". Returns the descriptor, and its port in `port`; or -1 and an error message in
/// `why`.
int listenOnTcp(const std::string& address, int& port, std::string& why);

}  // namespace gluray::control
