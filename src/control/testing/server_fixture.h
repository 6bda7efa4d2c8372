// A hub on real sockets in a temporary directory, for tests. One thread runs the hub and the test.
#pragma once
#include "control/connection/connect.h"
#include "control/hub/server/hub_server.h"
#include "control/messages/parsed.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace gluray::control::test {

using nlohmann::json;
using namespace std::chrono_literals;

class HubServerTest : public testing::Test {
 protected:
  HubServerTest()
      : folder_(std::filesystem::path(testing::TempDir()) / ("gluray-hub-" + std::to_string(getpid()))) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    options_.directory = folder_ / "run";
  }
  ~HubServerTest() override {
    for (const int socket : sockets_) ::close(socket);
    std::filesystem::remove_all(folder_);
  }
  std::string path() const { return socketIn(options_.directory); }
  void start() { ASSERT_EQ(hub_.start(options_), ""); }

  /// Runs the hub until `done` holds. Returns false if that takes longer than on any machine.
  bool until(const std::function<bool()>& done) {
    const auto end = std::chrono::steady_clock::now() + 30s;
    while (!done()) {
      if (std::chrono::steady_clock::now() > end) return false;
      io_.restart();
      io_.run_for(5ms);
    }
    return true;
  }

  /// A connected plain socket.
  int connectHere() {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path().c_str(), sizeof address.sun_path - 1);
    return connectTo(reinterpret_cast<const sockaddr*>(&address), sizeof address, AF_UNIX);
  }
  int connectTo(const sockaddr* address, socklen_t size, int family) {
    const int socket = ::socket(family, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (::connect(socket, address, size) != 0) return ::close(socket), -1;
    sockets_.push_back(socket);
    return socket;
  }
  static void giveBytes(int socket, const std::string& bytes) {
    for (size_t sent = 0; sent < bytes.size();) {
      const ssize_t count = send(socket, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
      if (count < 0) return;
      sent += static_cast<size_t>(count);
    }
  }
  static void give(int socket, const json& message) { giveBytes(socket, lineOf(message)); }

  /// The next message; null if the peer has closed the connection.
  json nextMessage(int socket) {
    std::string line;
    bool closed = false;
    until([&] {
      char byte = 0;
      ssize_t got = 0;
      while ((got = recv(socket, &byte, 1, MSG_DONTWAIT)) == 1 && byte != '\n') line += byte;
      closed = got == 0 || (got < 0 && errno != EAGAIN);
      return closed || byte == '\n';
    });
    return closed ? json{} : parse(line).message;
  }
  /// Whether the peer closes the connection. `said`: receives its messages before that.
  bool closes(int socket, std::vector<json>* said = nullptr) {
    for (int i = 0; i < 100; ++i) {
      json message = nextMessage(socket);
      if (message.is_null()) return true;
      if (said) said->push_back(std::move(message));
    }
    return false;
  }
  int client() {
    const int socket = connectHere();
    give(socket, json{{"type", "hello"}, {"version", 1}, {"role", "client"}});
    EXPECT_EQ(nextMessage(socket)["role"], "hub");
    return socket;
  }

  const std::filesystem::path folder_;
  asio::io_context io_;
  HubServer hub_{io_};
  HubOptions options_;
  std::vector<int> sockets_;
};

}  // namespace gluray::control::test
