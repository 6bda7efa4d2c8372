// Connects to a hub on another machine. On the thread that runs the io_context.
#pragma once
#include "control/connection/connect.h"

#include <optional>

namespace gluray::control {

/// The two parts of "HOST:PORT" or "[IPv6]:PORT"; nullopt for other texts, or if the port is not from 0 to
/// 65535.
struct HostAndPort {
  std::string host;
  int port = 0;
};
std::optional<HostAndPort> hostAndPort(const std::string& text);

/// Like connectToHub(), for an address with a host: looks the name up, connects and proves knowledge of the
/// key, within 3 s.
void connectByTcp(asio::io_context& io, const HubAddress& address, ConnectedOrNot connected);

/// Makes the system detect a connection that has been dead for a minute, even while data waits to be sent
/// over it.
void keepAlive(int socket);

}  // namespace gluray::control
