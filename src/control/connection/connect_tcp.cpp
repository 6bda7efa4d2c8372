#include "control/connection/connect_tcp.h"

#include "control/auth/handshake.h"

#include <asio/ip/tcp.hpp>
#include <asio/post.hpp>
#include <asio/steady_timer.hpp>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <algorithm>
#include <charconv>
#include <utility>
#include <vector>

namespace gluray::control {
namespace {

using asio::error_code;
using asio::ip::tcp;
using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr milliseconds kConnectPatience{3000};
constexpr int kMaxPort = 65535;

/// A close-on-exec socket. Throws if it cannot be watched.
std::optional<HandshakeSocket> newSocket(asio::io_context& io, const tcp::endpoint& to) {
  const int family = to.protocol().family();
  Descriptor socket(::socket(family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, IPPROTO_TCP));
  if (socket.get() < 0) return std::nullopt;
  keepAlive(socket.get());
  return socketOf(io, family, IPPROTO_TCP, std::move(socket));
}

/// One attempt to connect. It keeps itself alive while operations are pending.
class TcpAttempt : public std::enable_shared_from_this<TcpAttempt> {
 public:
  TcpAttempt(asio::io_context& io, const std::string& name, const Key& key, ConnectedOrNot connected)
      : io_(io), name_(name), key_(key), connected_(std::move(connected)), resolver_(io), timer_(io) {}

  void start(const HostAndPort& to) {
    end_ = steady_clock::now() + kConnectPatience;
    timer_.expires_at(end_);
    timer_.async_wait([self = shared_from_this()](const error_code& error) {
      if (!error) self->fail("it does not answer within 3 s");
    });
    error_code ignored;
    const auto address = asio::ip::make_address(to.host, ignored);
    if (!ignored) {  // no thread for looking up names
      endpoints_ = {tcp::endpoint(address, static_cast<unsigned short>(to.port))};
      return asio::post(io_, [self = shared_from_this()] { self->tryNext("it has no address"); });
    }
    resolver_.async_resolve(
        to.host, std::to_string(to.port),
        [self = shared_from_this()](const error_code& error, const tcp::resolver::results_type& all) {
          if (error) return self->fail(error.message());
          for (const auto& each : all) self->endpoints_.push_back(each.endpoint());
          self->tryNext("it has no address");
        });
  }

 private:
  void tryNext(const std::string& whyNot) {
    if (!connected_) return;
    if (tried_ == endpoints_.size()) return fail(whyNot);
    const tcp::endpoint to = endpoints_[tried_++];
    socket_ = newSocket(io_, to);
    if (!socket_) return tryNext("no socket can be made");
    socket_->async_connect(HandshakeSocket::endpoint_type(to),
                           [self = shared_from_this()](const error_code& error) {
                             if (!self->connected_) return;
                             if (error) return self->tryNext(error.message());
                             self->prove();
                           });
  }

  void prove() {
    timer_.cancel();
    const auto left = std::chrono::duration_cast<milliseconds>(end_ - steady_clock::now());
    proveAsPeer(std::move(*socket_), key_, std::max(left, milliseconds(1)),
                [self = shared_from_this()](PeerProof&& proof) {
                  if (!proof.socket) return self->fail(proof.why, proof.failure);
                  const ConnectedOrNot connected = std::exchange(self->connected_, nullptr);
                  if (connected)
                    connected(std::make_shared<Connection>(std::move(*proof.socket)), "",
                              ConnectFailure::none);
                });
  }

  void fail(const std::string& why, ConnectFailure failure = ConnectFailure::unreachable) {
    const ConnectedOrNot connected = std::exchange(connected_, nullptr);
    if (!connected) return;
    timer_.cancel();
    resolver_.cancel();
    error_code ignored;
    if (socket_) socket_->close(ignored);
    connected(nullptr, "the hub at " + name_ + ": " + why, failure);
  }

  asio::io_context& io_;
  const std::string name_;
  const Key key_;
  ConnectedOrNot connected_;  // empty after it was called
  tcp::resolver resolver_;
  asio::steady_timer timer_;
  steady_clock::time_point end_;
  std::vector<tcp::endpoint> endpoints_;
  size_t tried_ = 0;
  std::optional<HandshakeSocket> socket_;
};

}  // namespace

std::optional<HostAndPort> hostAndPort(const std::string& text) {
  const size_t colon = text.rfind(':');
  if (colon == text.npos) return std::nullopt;
  HostAndPort result{text.substr(0, colon), 0};
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data() + colon + 1, end, result.port);
  if (read.ec != std::errc{} || read.ptr != end || result.port < 0 || result.port > kMaxPort)
    return std::nullopt;
  std::string& host = result.host;
  if (host.size() > 2 && host.front() == '[' && host.back() == ']')
    host = host.substr(1, host.size() - 2);
  else if (host.find_first_of(":[]") != host.npos)
    return std::nullopt;
  if (host.empty()) return std::nullopt;
  return result;
}

void keepAlive(int socket) {
  const int on = 1, idleSeconds = 30, betweenSeconds = 10, probes = 3;
  setsockopt(socket, SOL_SOCKET, SO_KEEPALIVE, &on, sizeof on);
  setsockopt(socket, IPPROTO_TCP, TCP_KEEPIDLE, &idleSeconds, sizeof idleSeconds);
  setsockopt(socket, IPPROTO_TCP, TCP_KEEPINTVL, &betweenSeconds, sizeof betweenSeconds);
  setsockopt(socket, IPPROTO_TCP, TCP_KEEPCNT, &probes, sizeof probes);
  const unsigned int mostUnacknowledged = 60000;  // milliseconds; probes are not sent while data waits
  setsockopt(socket, IPPROTO_TCP, TCP_USER_TIMEOUT, &mostUnacknowledged, sizeof mostUnacknowledged);
  setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

void connectByTcp(asio::io_context& io, const HubAddress& address, ConnectedOrNot connected) {
  const auto to = hostAndPort(address.host);
  KeyOrWhy key;
  if (!to || to->port == 0)
    key.why = "hub = " + address.host + ": use HOST:PORT, or [ADDRESS]:PORT for IPv6";
  else
    key = readKey(address.keyFile);
  if (!key.why.empty())
    return asio::post(io, [connected = std::move(connected), why = key.why] {
      connected(nullptr, why, ConnectFailure::settings);
    });
  std::make_shared<TcpAttempt>(io, address.host, key.key, std::move(connected))->start(*to);
}

}  // namespace gluray::control
