#include "control/hub/server/unproven_connections.h"

#include <utility>

namespace gluray::control {

void UnprovenConnections::makeRoomFor(const std::string& address) {
  if (const auto other = peers_.toClose(address)) close(*other);
}

void UnprovenConnections::closeOne() {
  if (const auto other = peers_.leastDeserving()) close(*other);
}

void UnprovenConnections::leave(uint64_t number) {
  peers_.leave(number);
  closing_.erase(number);
}

void UnprovenConnections::close(uint64_t number) {
  const auto found = closing_.find(number);
  const std::function<void()> closeIt = found == closing_.end() ? nullptr : std::move(found->second);
  leave(number);
  if (closeIt) closeIt();
}

}  // namespace gluray::control
