// Sockets between processes of one user on one machine. Any thread.
#pragma once
#include "control/descriptor.h"

#include <string>

namespace gluray::control {

/// Connects to a listening Unix socket. The result does not block, and child processes do not get it.
/// Negative, and one line in `why`: not connected; `nobody`: because no process listens there.
Descriptor connectedSocket(const std::string& path, std::string& why, bool& nobody);

/// Whether the process at the other end of a Unix socket runs for this user.
bool sameUser(int socket);

}  // namespace gluray::control
