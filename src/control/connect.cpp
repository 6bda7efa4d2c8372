#include "control/connect.h"

#include "control/connect_tcp.h"
#include "control/runtime_directory.h"

#include <asio/local/stream_protocol.hpp>
#include <asio/post.hpp>
#include <sys/socket.h>
#include <sys/un.h>

#include <cerrno>
#include <cstring>
#include <exception>
#include <system_error>
#include <utility>

namespace gluray::control {
namespace {

/// A connected socket that child processes do not get; none and `why`.
Descriptor connectedSocket(const std::string& path, std::string& why) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) {
    why = path + ": the path is too long for a socket; set GLURAY_RUNTIME to a shorter one";
    return Descriptor();
  }
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  Descriptor socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (socket.get() < 0 ||
      connect(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    const int error = errno;
    why = error == ENOENT || error == ECONNREFUSED
              ? "no hub runs here; start gluray panel or gluray hub"
              : path + ": " + std::error_code(error, std::generic_category()).message();
    return Descriptor();
  }
  if (!sameUser(socket.get())) {
    why = "the hub of " + path + " belongs to another user";
    return Descriptor();
  }
  return socket;
}

std::shared_ptr<Connection> connectHere(asio::io_context& io, const std::string& directory,
                                        std::string& why) {
  if (why = whyUnsafe(directory); !why.empty()) return nullptr;
  try {
    Descriptor socket = connectedSocket(socketIn(directory), why);
    if (socket.get() < 0) return nullptr;
    return std::make_shared<Connection>(socketOf(io, AF_UNIX, 0, std::move(socket)));
  } catch (const std::exception& error) {
    why = std::string("no connection can be made: ") + error.what();
    return nullptr;
  }
}

}  // namespace

std::string socketIn(const std::string& directory) { return directory + "/hub.sock"; }

bool sameUser(int socket) {
  ucred peer{};
  socklen_t size = sizeof peer;
  return getsockopt(socket, SOL_SOCKET, SO_PEERCRED, &peer, &size) == 0 && peer.uid == geteuid();
}

void connectToHub(asio::io_context& io, const HubAddress& address, Connected connected) {
  connectToHub(
      io, address,
      [connected = std::move(connected)](std::shared_ptr<Connection> connection, const std::string& why,
                                         ConnectFailure) { connected(std::move(connection), why); });
}

void connectToHub(asio::io_context& io, const HubAddress& address, ConnectedOrNot connected) {
  if (!address.host.empty()) return connectByTcp(io, address, std::move(connected));
  std::string why;
  std::shared_ptr<Connection> connection = connectHere(io, address.directory, why);
  asio::post(io, [connected = std::move(connected), connection = std::move(connection), why] {
    connected(connection, why, connection ? ConnectFailure::none : ConnectFailure::unreachable);
  });
}

}  // namespace gluray::control
