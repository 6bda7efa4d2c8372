// Connects programs and clients to the hub. Any thread; callbacks on the thread that runs the io_context.
#pragma once
#include "control/connect_failure.h"
#include "control/connection/connection.h"

#include <asio/io_context.hpp>

#include <functional>
#include <memory>
#include <string>

namespace gluray::control {

/// Address of the hub.
struct HubAddress {
  std::string directory;  // its runtime directory, if `host` is empty
  std::string host;       // "HOST:PORT" for TCP; empty: on this machine
  std::string keyFile;    // for TCP
};

/// Receives a connection that is not started and over which only the authentication has been sent, or null
/// and a one-line error message.
using Connected = std::function<void(std::shared_ptr<Connection> connection, const std::string& why)>;

/// Like Connected, with the kind of the failure.
using ConnectedOrNot = std::function<void(std::shared_ptr<Connection> connection, const std::string& why,
                                          ConnectFailure failure)>;

/// Connects without blocking. Calls `connected` once, after returning. Over TCP it takes at most 3 s. A host
/// given by name is looked up on a thread of asio, for which the io_context's destructor waits.
void connectToHub(asio::io_context& io, const HubAddress& address, Connected connected);
void connectToHub(asio::io_context& io, const HubAddress& address, ConnectedOrNot connected);

/// The path of the hub's socket in a runtime directory.
std::string socketIn(const std::string& directory);

}  // namespace gluray::control
