// Connects programs and clients to the hub. Any thread; callbacks on the thread that runs the io_context.
#pragma once
#include "control/connect_failure.h"
#include "control/connection/connection.h"

#include <asio/io_context.hpp>

#include <functional>
#include <memory>
#include <string>

namespace gluray::control {

/// Where the hub is.
struct HubAddress {
  std::string directory;  // its runtime directory, unless `host` says otherwise
  std::string host;       // "HOST:PORT": by TCP; empty: on this machine
  std::string keyFile;    // for TCP
};

/// A connection over which nothing but the authentication has been sent, not started; or null and one line
/// that says why.
using Connected = std::function<void(std::shared_ptr<Connection> connection, const std::string& why)>;

/// The same, with a reason to decide by.
using ConnectedOrNot = std::function<void(std::shared_ptr<Connection> connection, const std::string& why,
                                          ConnectFailure failure)>;

/// Never blocks. Calls `connected` once, not before it returns. By TCP it takes 3 s at most; a host that is a
/// name is looked up on a thread of asio's, for which the io_context waits when it is destroyed.
void connectToHub(asio::io_context& io, const HubAddress& address, Connected connected);
void connectToHub(asio::io_context& io, const HubAddress& address, ConnectedOrNot connected);

/// The path of the hub's socket in a runtime directory.
std::string socketIn(const std::string& directory);

}  // namespace gluray::control
