// Limits unauthenticated TCP connections, so that an address with many connections cannot block others. No
// sockets. On the hub's thread.
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace gluray::control {

/// The addresses that one machine may choose from: an IPv4 address, the first 64 bits of an IPv6 address.
/// IPv4 addresses mapped into IPv6 are IPv4 addresses. `address`: numeric; other texts are returned
/// unchanged.
std::string networkOf(const std::string& address);

class WaitingPeers {
 public:
  static constexpr size_t kMax = 256, kMaxPerNetwork = 64;

  /// The connection to close before one from this address joins; none: there is room. That is the oldest one
  /// of the same network if that holds kMaxPerNetwork, or, where kMax wait, the oldest one of the network
  /// that holds most.
  std::optional<uint64_t> toClose(const std::string& address) const;
  /// The oldest connection of the network that holds most; none: nobody waits.
  std::optional<uint64_t> leastDeserving() const;
  /// Its number, which rises.
  uint64_t join(const std::string& address);
  void leave(uint64_t number);
  size_t size() const { return networks_.size(); }

 private:
  std::optional<uint64_t> oldestOf(const std::string& network) const;
  std::map<uint64_t, std::string> networks_;  // of each connection, the oldest first
  std::map<std::string, size_t> counts_;
  uint64_t last_ = 0;
};

}  // namespace gluray::control
