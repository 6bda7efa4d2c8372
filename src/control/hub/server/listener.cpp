#include "control/hub/server/listener.h"

#include "control/connection/connect_tcp.h"

#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <exception>
#include <system_error>

namespace gluray::control {
namespace {

using asio::error_code;

constexpr int kMaxAtOnce = 64, kTcpBacklog = 64;
constexpr std::chrono::milliseconds kWithoutDescriptors{200};

std::string numericAddress(const sockaddr_storage& address, socklen_t size) {
  if (address.ss_family == AF_UNIX) return "";
  std::array<char, NI_MAXHOST> host{};
  const int error = getnameinfo(reinterpret_cast<const sockaddr*>(&address), size, host.data(), host.size(),
                                nullptr, 0, NI_NUMERICHOST);
  return error == 0 ? host.data() : "?";
}

int portOf(int socket) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  if (getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size) != 0) return 0;
  if (address.ss_family == AF_INET) return ntohs(reinterpret_cast<const sockaddr_in&>(address).sin_port);
  return ntohs(reinterpret_cast<const sockaddr_in6&>(address).sin6_port);
}

int listenOn(const addrinfo& at) {
  const int socket = ::socket(at.ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, IPPROTO_TCP);
  if (socket < 0) return -1;
  const int on = 1;
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  if (bind(socket, at.ai_addr, at.ai_addrlen) == 0 && listen(socket, kTcpBacklog) == 0) return socket;
  const int error = errno;
  close(socket);
  errno = error;
  return -1;
}

}  // namespace

Listener::Listener(asio::io_context& io, Descriptor descriptor, Accepted accepted)
    : io_(io), descriptor_(io), pause_(io), accepted_(std::move(accepted)) {
  error_code error;
  descriptor_.assign(descriptor.get(), error);
  if (error) throw std::system_error(error);
  descriptor.release();
}

void Listener::handOver(Descriptor socket, const sockaddr_storage& address, socklen_t size) {
  const int protocol = address.ss_family == AF_UNIX ? 0 : IPPROTO_TCP;
  try {
    accepted_(socketOf(io_, address.ss_family, protocol, std::move(socket)), numericAddress(address, size));
  } catch (const std::exception&) {  // out of memory: the socket is closed
  }
}

void Listener::wait() {
  descriptor_.async_wait(asio::posix::stream_descriptor::wait_read,
                         [self = shared_from_this()](const error_code& error) {
                           if (!error && self->descriptor_.is_open()) self->accept();
                         });
}

void Listener::accept() {
  for (int i = 0; i < kMaxAtOnce && descriptor_.is_open(); ++i) {
    sockaddr_storage address{};
    socklen_t size = sizeof address;
    const int socket = accept4(descriptor_.native_handle(), reinterpret_cast<sockaddr*>(&address), &size,
                               SOCK_CLOEXEC | SOCK_NONBLOCK);
    if (socket >= 0) {
      handOver(Descriptor(socket), address, size);
      continue;
    }
    if (errno == EINTR || errno == ECONNABORTED) continue;
    if (errno == EAGAIN) break;
    // Out of descriptors or memory: waiting connections stay readable, so that waiting for them would use a
    // whole core.
    pause_.expires_after(kWithoutDescriptors);
    return pause_.async_wait([self = shared_from_this()](const error_code& error) {
      if (!error && self->descriptor_.is_open()) self->accept();
    });
  }
  if (descriptor_.is_open()) wait();
}

void Listener::stop() {
  error_code ignored;
  descriptor_.close(ignored);
  pause_.cancel();
}

int listenOnTcp(const std::string& address, int& port, std::string& why) {
  const auto at = hostAndPort(address);
  if (!at) return why = "--listen " + address + ": use HOST:PORT, or [ADDRESS]:PORT for IPv6", -1;
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_PASSIVE | AI_NUMERICSERV;
  addrinfo* found = nullptr;
  const int error = getaddrinfo(at->host.c_str(), std::to_string(at->port).c_str(), &hints, &found);
  if (error != 0) return why = address + ": " + gai_strerror(error), -1;
  int socket = -1;
  for (const addrinfo* each = found; each && socket < 0; each = each->ai_next) socket = listenOn(*each);
  if (socket < 0) why = address + ": " + std::error_code(errno, std::generic_category()).message();
  freeaddrinfo(found);
  if (socket >= 0) port = portOf(socket);
  return socket;
}

}  // namespace gluray::control
