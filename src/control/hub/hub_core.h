// The hub without sockets and clocks: tracks connections and routes messages (docs/control-protocol.md).
// HubServer calls it, on its thread.
#pragma once
#include "control/hub/requests.h"

#include <string>

namespace gluray::control {

inline constexpr size_t kMaxRequests = 256;  // of one client, that wait
inline constexpr std::chrono::seconds kHelloPatience{5};

class HubCore {
 public:
  struct Self {
    std::string host;
    int pid = 0;
    double secondsAtZero = 0;  // since 1970, when HubTime is 0
  };
  explicit HubCore(Self self);

  /// What the hub's hello says of the programs that may still come.
  struct Beginning {
    size_t expected = 0;  // programs that left a file, run, and are not connected
    double age = 0;       // seconds since the hub began
    bool tcp = false;     // it listens there: programs of other machines leave no files
  };
  /// A new connection, with a number that was not used before, not 0. Sends the hub's hello.
  void connected(uint64_t connection, PeerLink link, HubTime now, const Beginning& beginning);
  void connected(uint64_t connection, PeerLink link, HubTime now) {
    connected(connection, std::move(link), now, Beginning{});
  }
  /// A message: an object with a text `type`, and anything else.
  void received(uint64_t connection, const nlohmann::json& message, HubTime now);
  void disconnected(uint64_t connection, HubTime now);
  /// All that was sent to it has been given to the system.
  void drained(uint64_t connection, HubTime now);
  /// Does what is due.
  void passed(HubTime now);
  /// When passed() must be called.
  HubTime nextDue();

  size_t programs() const { return programs_.connections(); }
  /// Connected clients, and connections that may become one.
  size_t clients() const;
  /// Whether a program with this process of this host is connected.
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
