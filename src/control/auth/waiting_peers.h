// Limits unauthenticated TCP connections, so that an address with many connections cannot block others. No
// sockets. On the hub's thread.
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace gluray::control {

/// The network whose addresses one machine may choose from: an IPv4 address, or the first 64 bits of an IPv6
/// address. IPv4 addresses mapped into IPv6 count as IPv4 addresses. `address`: numeric; other texts are
/// returned unchanged.
std::string networkOf(const std::string& address);

class WaitingPeers {
 public:
  static constexpr size_t kMax = 256, kMaxPerNetwork = 64;

  /// The connection to close before one from this address joins; nullopt if there is room. If the network has
  /// kMaxPerNetwork connections, it is the oldest of these. If there are kMax connections in all, it is the
  /// oldest of the network that has most.
  std::optional<uint64_t> toClose(const std::string& address) const;
  /// The oldest connection of the network that has most; nullopt if there are no connections.
  std::optional<uint64_t> leastDeserving() const;
  /// Adds a connection and returns its number. Numbers increase.
  uint64_t join(const std::string& address);
  void leave(uint64_t number);
  size_t size() const { return networks_.size(); }

 private:
  std::optional<uint64_t> oldestOf(const std::string& network) const;
  std::map<uint64_t, std::string> networks_;  // network of each connection, oldest first
  std::map<std::string, size_t> counts_;
  uint64_t last_ = 0;
};

}  // namespace gluray::control
