// The hub's connections, and messages to them. Has no sockets: their owner passes functions. On the hub's
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

/// A connection as the hub uses it. The functions must not call the hub.
struct PeerLink {
  using Line = std::shared_ptr<const std::string>;  // including its line feed
  std::function<void(Line)> send;
  std::function<size_t()> waiting;                     // bytes that wait to be sent
  std::function<void(const std::string& why)> finish;  // closes it after waiting data has been sent
};

enum class Role { unknown, program, client };

struct Peer {
  PeerLink link;
  Role role = Role::unknown;
  HubTime helloLimit;  // while the role is unknown
  // Ids of requests that wait for answers, as text: JSON values with mixed kinds of numbers have no order.
  std::set<std::string> ids;
  bool finished = false;  // it is being closed: its messages are ignored
};

class Peers {
 public:
  void add(uint64_t connection, PeerLink link, HubTime helloLimit);
  void remove(uint64_t connection) { peers_.erase(connection); }
  Peer* find(uint64_t connection);
  const std::map<uint64_t, Peer>& all() const { return peers_; }

  /// Sends a message. Returns false if receivers would refuse it. Does nothing for a closed connection.
  bool send(uint64_t to, const nlohmann::json& message);
  void send(uint64_t to, const PeerLink::Line& line);
  /// Sends an answer. If it is too long or too deep, sends an error instead.
  void answer(uint64_t to, const nlohmann::json& id, nlohmann::json&& body);
  /// Sends an `error` and keeps the connection.
  void complain(uint64_t to, const std::string& why);
  /// Sends an `error` and closes the connection.
  void expel(uint64_t connection, const std::string& why);
  size_t waiting(uint64_t connection);

 private:
  std::map<uint64_t, Peer> peers_;
};

}  // namespace gluray::control
