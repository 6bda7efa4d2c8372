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
  /// Gets a socket that does not block and that child processes do not get. `address`: the other side's IP
  /// address, empty for a Unix socket. Where it throws, that connection is closed, and others are accepted.
  using Accepted = std::function<void(Connection::Socket socket, const std::string& address)>;

  /// Takes the listening descriptor.
  Listener(asio::io_context& io, Descriptor descriptor, Accepted accepted);
  void start() { wait(); }
  void stop();
  /// Accepts what waits. Where descriptors are used up it looks again a moment later.
  void accept();

 private:
  void wait();
  void handOver(Descriptor socket, const sockaddr_storage& address, socklen_t size);
  asio::io_context& io_;
  asio::posix::stream_descriptor descriptor_;
  asio::steady_timer pause_;
  Accepted accepted_;
};

/// Listens on "HOST:PORT". Returns the descriptor, and in `port` its port; -1 and `why`.
int listenOnTcp(const std::string& address, int& port, std::string& why);

}  // namespace gluray::control
