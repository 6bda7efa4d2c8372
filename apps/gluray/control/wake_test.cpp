#include "wake/wake.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>

namespace gluray {
namespace {

constexpr int kDisplayPort = 6000;  // of display 0

/// An X server that accepts connections, and never answers.
struct SilentDisplay {
  SilentDisplay() {
    socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    for (number = 300; number < 400; ++number) {
      address.sin_port = htons(static_cast<uint16_t>(kDisplayPort + number));
      if (bind(socket, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0) break;
    }
    listen(socket, 64);
  }
  ~SilentDisplay() { close(socket); }
  int socket = -1, number = 0;
};

TEST(Wake, WindowsOfADisplayAreWokenOneAfterTheOther) {
  const SilentDisplay display;
  const std::string name = "127.0.0.1:" + std::to_string(display.number);
  for (unsigned long window = 1; window <= 20; ++window) wakeWindow(name, window);
  int open = 0;
  const auto begin = std::chrono::steady_clock::now();
  int first = -1;
  while (std::chrono::steady_clock::now() - begin < std::chrono::seconds(1)) {
    const int made = accept(display.socket, nullptr, nullptr);
    if (made >= 0 && open++ == 0)
      first = made;
    else if (made >= 0)
      close(made);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  EXPECT_EQ(open, 1);
  close(first);
}

}  // namespace
}  // namespace gluray
