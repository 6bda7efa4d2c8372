// The hub without sockets and clocks: tracks connections and routes messages (docs/control-protocol.md).
// HubServer calls it, on its thread.
#pragma once
#include "control/hub/requests.h"

#include <string>

namespace gluray::control {

inline constexpr size_t kMaxRequests = 256;  // limit of one client's pending requests
inline constexpr std::chrono::seconds kHelloPatience{5};

class HubCore {
 public:
  struct Self {
    std::string host;
    int pid = 0;
    double secondsAtZero = 0;  // since 1970, when HubTime is 0
  };
  explicit HubCore(Self self);

  /// Contents of the hub's hello about programs that may still connect.
  struct Beginning {
    size_t expected = 0;  // programs that left a file, run, and are not connected
    double age = 0;       // seconds since the hub began
    bool tcp = false;     // the hub listens on TCP: programs on other machines leave no files
  };
  /// Adds a connection. `connection`: a number that was not used before, not 0. Sends the hub's hello.
  void connected(uint64_t connection, PeerLink link, HubTime now, const Beginning& beginning);
  void connected(uint64_t connection, PeerLink link, HubTime now) {
    connected(connection, std::move(link), now, Beginning{});
  }
  /// Handles a message: an object with a text `type` and any other contents.
  void received(uint64_t connection, const nlohmann::json& message, HubTime now);
  void disconnected(uint64_t connection, HubTime now);
  /// Reports that everything sent over the connection has been passed to the system.
  void drained(uint64_t connection, HubTime now);
  /// Does what is due at this time.
  void passed(HubTime now);
  /// Time at which passed() must be called next.
  HubTime nextDue();

  size_t programs() const { return programs_.connections(); }
  /// Number of connected clients, and of connections that may become clients.
  size_t clients() const;
  /// Whether the program with this process on this host is connected.
  bool hasProcess(int pid) const { return programs_.hasProcess(self_.host, pid); }

 private:
  void hello(uint64_t connection, Peer& peer, const nlohmann::json& message);
  void fromProgram(uint64_t connection, const std::string& type, const nlohmann::json& message);
  void fromClient(uint64_t connection, Peer& peer, const nlohmann::json& message);
  void due();

  const Self self_;
  Peers peers_;
  Programs programs_;
  Questions questions_;
  ChangeQueue changes_;
  Observers observers_;
  Requests requests_;
};

}  // namespace gluray::control
