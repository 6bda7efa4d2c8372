#include "control/connect.h"

#include "control/connect_tcp.h"
#include "control/runtime_directory.h"

#include <asio/local/stream_protocol.hpp>
#include <asio/post.hpp>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

namespace gluray::control {
namespace {

/// A connected socket that child processes do not get; -1 and `why`.
int connectedSocket(const std::string& path, std::string& why) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) {
    why = path + ": the path is too long for a socket; set GLURAY_RUNTIME to a shorter one";
    return -1;
  }
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  const int socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (socket < 0 || connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    const int error = errno;
    why = error == ENOENT || error == ECONNREFUSED
              ? "no hub runs here; start gluray panel or gluray hub"
              : path + ": " + std::error_code(error, std::generic_category()).message();
    if (socket >= 0) ::close(socket);
    return -1;
  }
  if (!sameUser(socket)) {
    why = "the hub of " + path + " belongs to another user";
    ::close(socket);
    return -1;
  }
  return socket;
}

std::shared_ptr<Connection> connectHere(asio::io_context& io, const std::string& directory,
                                        std::string& why) {
  if (why = whyUnsafe(directory); !why.empty()) return nullptr;
  const int socket = connectedSocket(socketIn(directory), why);
  if (socket < 0) return nullptr;
  return std::make_shared<Connection>(
      Connection::Socket(io, Connection::Socket::protocol_type(AF_UNIX, 0), socket));
}

}  // namespace

std::string socketIn(const std::string& directory) { return directory + "/hub.sock"; }

bool sameUser(int socket) {
  ucred peer{};
  socklen_t size = sizeof peer;
  return getsockopt(socket, SOL_SOCKET, SO_PEERCRED, &peer, &size) == 0 && peer.uid == geteuid();
}

void connectToHub(asio::io_context& io, const HubAddress& address, Connected connected) {
  if (!address.host.empty()) return connectByTcp(io, address, std::move(connected));
  std::string why;
  std::shared_ptr<Connection> connection = connectHere(io, address.directory, why);
  asio::post(io, [connected = std::move(connected), connection = std::move(connection), why] {
    connected(connection, why);
  });
}

}  // namespace gluray::control
