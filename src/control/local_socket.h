// Sockets between processes of one user on one machine. Any thread.
#pragma once
#include "control/descriptor.h"

#include <string>

namespace gluray::control {

/// Connects to a listening Unix socket and returns a non-blocking, close-on-exec descriptor. If that fails,
/// the descriptor is negative and `why` has a one-line error message. `nobody`: no process listens there.
Descriptor connectedSocket(const std::string& path, std::string& why, bool& nobody);

/// Whether the process at the other end of a Unix socket runs for this user.
bool sameUser(int socket);

}  // namespace gluray::control
