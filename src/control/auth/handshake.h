// Both sides of the authentication over TCP (docs/control-protocol.md). On the thread that runs the
// io_context.
#pragma once
#include "control/auth/key.h"
#include "control/connect_failure.h"

#include <asio/generic/stream_protocol.hpp>

#include <chrono>
#include <functional>
#include <optional>
#include <string>

namespace gluray::control {

using HandshakeSocket = asio::generic::stream_protocol::socket;

inline constexpr size_t kMaxHandshakeBytes = 256;  // of a message, including its line feed

/// Result of the hub's side. `wrong`: the peer sent something other than a valid proof, or nothing in time;
/// this is reported at once, and the socket closes half a second later. No socket and not `wrong`: the peer
/// has closed the connection.
struct HubProof {
  std::optional<HandshakeSocket> socket;  // nothing else was read from it or sent over it
  bool wrong = false;
};
/// Authenticates a peer. Calls `done` once, and `ended` when the socket is handed over or closed. Returns a
/// function that closes the socket at once, as if the peer had closed it; it has no effect after the end.
std::function<void()> proveAsHub(HandshakeSocket socket, const Key& key, std::chrono::milliseconds patience,
                                 std::function<void(HubProof&&)> done, std::function<void()> ended);

/// Result of the peer's side: the socket, over which nothing else was read or sent, or an error message.
struct PeerProof {
  std::optional<HandshakeSocket> socket;
  std::string why;
  ConnectFailure failure = ConnectFailure::none;
};
/// Authenticates to the hub. Calls `done` once. `patience`: limit for the whole handshake.
void proveAsPeer(HandshakeSocket socket, const Key& key, std::chrono::milliseconds patience,
                 std::function<void(PeerProof&&)> done);

}  // namespace gluray::control
