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

inline constexpr size_t kMaxHandshakeBytes = 256;  // of a message, with its line feed

/// What the hub's side came to. `wrong`: the other side sent something else than a right proof, or nothing in
/// time; reported at once, the socket closes half a second later. No socket and not `wrong`: it has gone.
struct HubProof {
  std::optional<HandshakeSocket> socket;  // nothing else was read from it or sent over it
  bool wrong = false;
};
/// Calls `done` once, and `ended` when the socket is handed over or closed. Returns what closes the socket at
/// once, as if the other side had gone; without effect when it is over.
std::function<void()> proveAsHub(HandshakeSocket socket, const Key& key, std::chrono::milliseconds patience,
                                 std::function<void(HubProof&&)> done, std::function<void()> ended);

/// The other side. The socket, over which nothing else was read or sent, or one line that says why there is
/// none.
struct PeerProof {
  std::optional<HandshakeSocket> socket;
  std::string why;
  ConnectFailure failure = ConnectFailure::none;
};
/// Calls `done` once. `patience`: for all of it.
void proveAsPeer(HandshakeSocket socket, const Key& key, std::chrono::milliseconds patience,
                 std::function<void(PeerProof&&)> done);

}  // namespace gluray::control
