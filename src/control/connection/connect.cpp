#include "control/connection/connect.h"

#include "control/connection/connect_tcp.h"
#include "control/local_socket.h"
#include "control/runtime_directory.h"

#include <asio/local/stream_protocol.hpp>
#include <asio/post.hpp>
#include <sys/socket.h>

#include <exception>
#include <utility>

namespace gluray::control {
namespace {

std::shared_ptr<Connection> connectHere(asio::io_context& io, const std::string& directory,
                                        std::string& why) {
  if (why = whyUnsafe(directory); !why.empty()) return nullptr;
  try {
    bool nobody = false;
    Descriptor socket = connectedSocket(socketIn(directory), why, nobody);
    if (nobody) why = "no hub runs here; start gluray panel or gluray hub";
    if (socket.get() < 0) return nullptr;
    return std::make_shared<Connection>(socketOf(io, AF_UNIX, 0, std::move(socket)));
  } catch (const std::exception& error) {
    why = std::string("no connection can be made: ") + error.what();
    return nullptr;
  }
}

}  // namespace

std::string socketIn(const std::string& directory) { return directory + "/hub.sock"; }

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
