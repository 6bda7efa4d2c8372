// The hub's connections and the messages to them. No sockets: their owner passes functions. On the hub's
// thread.
#pragma once
#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>

namespace gluray::control {

using HubTime = std::chrono::steady_clock::time_point;

/// One connection as the hub uses it. The functions must not call the hub.
struct PeerLink {
  using Line = std::shared_ptr<const std::string>;  // with its line feed
  std::function<void(Line)> send;
  std::function<size_t()> waiting;                     // bytes that wait to be sent
  std::function<void(const std::string& why)> finish;  // closes it after what waits has been sent
};

enum class Role { unknown, program, client };

struct Peer {
  PeerLink link;
  Role role = Role::unknown;
  HubTime helloLimit;  // while the role is unknown
  // Ids of requests that wait for answers, as text: JSON values of mixed kinds of numbers have no order.
  std::set<std::string> ids;
  bool finished = false;  // it is being closed: what it says is not read
};

class Peers {
 public:
  void add(uint64_t connection, PeerLink link, HubTime helloLimit);
  void remove(uint64_t connection) { peers_.erase(connection); }
  Peer* find(uint64_t connection);
  const std::map<uint64_t, Peer>& all() const { return peers_; }

  /// False: the message is one that receivers do not take. Nothing is sent to a connection that is gone.
  bool send(uint64_t to, const nlohmann::json& message);
  void send(uint64_t to, const PeerLink::Line& line);
  /// Sends an answer; one that is too long or too deep becomes one that says so.
  void answer(uint64_t to, const nlohmann::json& id, nlohmann::json&& body);
  /// Sends an `error`; the connection stays.
  void complain(uint64_t to, const std::string& why);
  /// Sends an `error` and closes the connection.
  void expel(uint64_t connection, const std::string& why);
  size_t waiting(uint64_t connection);

 private:
  std::map<uint64_t, Peer> peers_;
};

}  // namespace gluray::control
