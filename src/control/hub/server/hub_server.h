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
  std::string directory;  // its runtime directory; created if there is none
  std::string listen;     // "HOST:PORT" or "[IPv6]:PORT", port 0: any; empty: no TCP
  std::string keyFile;    // for TCP
  /// Makes the program behind a window draw; may be empty.
  std::function<void(const std::string& display, unsigned long window)> wake;
};

class HubServer {
 public:
  explicit HubServer(asio::io_context& io);
  ~HubServer();

  /// Listens from now on. Returns one line that says why it cannot; empty: it does.
  std::string start(const HubOptions& options);
  /// Closes all connections and removes the socket.
  void stop();

  bool otherHubRuns() const;  // why start() failed
  int port() const;           // of TCP; 0: it does not listen there
  size_t programs() const;    // connected ones that have said hello, ranks counted one by one
  size_t clients() const;     // connected ones, and connections that may become one
  size_t expected() const;    // programs that left a file, are alive, and are not connected

 private:
  class Parts;
  std::shared_ptr<Parts> parts_;
};

}  // namespace gluray::control
