#include "control/local_socket.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

namespace gluray::control {

Descriptor connectedSocket(const std::string& path, std::string& why, bool& nobody) {
  nobody = false;
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
    nobody = error == ENOENT || error == ECONNREFUSED;
    why = path + ": " + std::error_code(error, std::generic_category()).message();
    return Descriptor();
  }
  if (!sameUser(socket.get())) {
    why = "who listens at " + path + " is another user";
    return Descriptor();
  }
  return socket;
}

bool sameUser(int socket) {
  ucred peer{};
  socklen_t size = sizeof peer;
  return getsockopt(socket, SOL_SOCKET, SO_PEERCRED, &peer, &size) == 0 && peer.uid == geteuid();
}

}  // namespace gluray::control
