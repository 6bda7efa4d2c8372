// The hub: listens, and passes messages between programs and clients (docs/control-protocol.md). All calls on
// the thread that runs the io_context.
#pragma once
#include <asio/io_context.hpp>

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

namespace gluray::control {

struct HubOptions {
  std::string directory;  // its runtime directory; created if it does not exist
  std::string listen;     // "HOST:PORT" or "[IPv6]:PORT", port 0: any; empty: no TCP
  std::string keyFile;    // for TCP
  /// Makes the program behind a window draw. May be empty.
  std::function<void(const std::string& display, unsigned long window)> wake;
};

class HubServer {
 public:
  explicit HubServer(asio::io_context& io);
  ~HubServer();

  /// Starts listening. Returns a one-line error message; empty on success.
  std::string start(const HubOptions& options);
  /// Closes all connections and removes the socket.
  void stop();

  bool otherHubRuns() const;  // whether start() failed for that reason
  int port() const;           // TCP port; 0: it does not listen on TCP
  size_t programs() const;    // connected programs that have sent a hello, counted by rank
  size_t clients() const;     // connected clients, and connections that may become clients
  size_t expected() const;    // programs that left a file, run, and are not connected

 private:
  class Parts;
  std::shared_ptr<Parts> parts_;
};

}  // namespace gluray::control
