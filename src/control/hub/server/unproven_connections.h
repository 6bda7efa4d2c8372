// A hub's unauthenticated TCP connections, and the functions that close them. On the hub's thread.
#pragma once
#include "control/auth/waiting_peers.h"

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>

namespace gluray::control {

class UnprovenConnections {
 public:
  size_t size() const { return peers_.size(); }
  /// Closes the connection that a new one from this address displaces, if there is one.
  void makeRoomFor(const std::string& address);
  /// Closes the oldest connection of the network that has most, if there is one.
  void closeOne();
  /// Adds a connection and returns its number.
  uint64_t join(const std::string& address) { return peers_.join(address); }
  /// Sets the function that closes a connection. Call once, after join().
  void setClose(uint64_t number, std::function<void()> close) { closing_[number] = std::move(close); }
  /// Reports that the connection has authenticated, or is closed.
  void leave(uint64_t number);

 private:
  void close(uint64_t number);

  WaitingPeers peers_;
  std::map<uint64_t, std::function<void()>> closing_;  // by number
};

}  // namespace gluray::control
