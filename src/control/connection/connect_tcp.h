// Connects to a hub on another machine. On the thread that runs the io_context.
#pragma once
#include "control/connection/connect.h"

#include <optional>

namespace gluray::control {

/// "HOST:PORT" or "[IPv6]:PORT" in two parts; none: it is neither, or the port is not from 0 to 65535.
struct HostAndPort {
  std::string host;
  int port = 0;
};
std::optional<HostAndPort> hostAndPort(const std::string& text);

/// As connectToHub(), for an address with a host. Looks the name up, connects and proves that it knows the
/// key, in 3 s.
void connectByTcp(asio::io_context& io, const HubAddress& address, ConnectedOrNot connected);

/// A connection that has been dead for a minute is found to be, also while something waits to be sent over
/// it.
void keepAlive(int socket);

}  // namespace gluray::control
