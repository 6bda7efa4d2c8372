#include "intercept/control/x_server.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>
#include <xcb/xcb.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace gluray::intercept {
namespace {

constexpr uint32_t kWindow = 0x400001;
constexpr uint16_t kWidth = 320, kHeight = 200;

/// An X server of one window, slow to look at its connections. As real ones do, it forgets what it has not
/// read of a connection that has been closed.
class SlowServer {
 public:
  SlowServer() {
    std::error_code known;
    std::filesystem::create_directory(kFolder, known);
    listener_ = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    while (!bound()) ++number_;
    EXPECT_EQ(::listen(listener_, 4), 0);
    thread_ = std::thread([this] { serve(); });
  }
  ~SlowServer() {
    ends_ = true;
    thread_.join();
    ::close(listener_);
    std::filesystem::remove(path());
  }
  SlowServer(const SlowServer&) = delete;
  SlowServer& operator=(const SlowServer&) = delete;

  std::string display() const { return ":" + std::to_string(number_); }
  /// Events that it has delivered, by their type.
  int delivered(int type) const { return type == XCB_EXPOSE ? exposed_ : configured_; }

 private:
  static constexpr const char* kFolder = "/tmp/.X11-unix";
  std::string path() const { return kFolder + std::string("/X") + std::to_string(number_); }
  bool bound() const {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path().copy(address.sun_path, sizeof address.sun_path - 1);
    return ::bind(listener_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 ||
           errno != EADDRINUSE;
  }

  void serve() {
    while (!ends_) {
      pollfd listens{listener_, POLLIN, 0};
      if (::poll(&listens, 1, 5) == 1) connection_ = ::accept(listener_, nullptr, nullptr);
      if (connection_ < 0) continue;
      setUp();
      while (answers()) {}
      ::close(connection_);
      connection_ = -1;
    }
  }

  /// False: the connection is closed.
  bool waits() {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    while (!ends_) {
      pollfd ready{connection_, POLLIN, 0};
      if (::poll(&ready, 1, 5) == 1) return !(ready.revents & (POLLHUP | POLLERR));
    }
    return false;
  }
  bool read(void* bytes, size_t count) {
    return ::recv(connection_, bytes, count, MSG_WAITALL) == static_cast<ssize_t>(count);
  }
  template <class Message>
  void send(const Message& message) {
    EXPECT_EQ(::send(connection_, &message, sizeof message, MSG_NOSIGNAL), ssize_t{sizeof message});
  }

  void setUp() {
    xcb_setup_request_t asked{};
    if (!waits() || !read(&asked, sizeof asked)) return;
    std::vector<char> names((asked.authorization_protocol_name_len + 3u) / 4 * 4 +
                            (asked.authorization_protocol_data_len + 3u) / 4 * 4);
    if (!names.empty()) read(names.data(), names.size());
    xcb_setup_t setup{};
    sequence_ = 0;
    setup.status = 1, setup.protocol_major_version = 11;
    setup.length = (sizeof setup - 8) / 4;
    setup.resource_id_base = 0x200000, setup.resource_id_mask = 0x1fffff;
    setup.maximum_request_length = 0xffff;
    send(setup);
  }

  /// Executes one request.
  bool answers() {
    std::array<char, 4> head{};
    if (!waits() || !read(head.data(), head.size())) return false;
    const size_t words = static_cast<uint8_t>(head[2]) + 256u * static_cast<uint8_t>(head[3]);
    std::vector<char> rest(4 * words - head.size());
    if (!read(rest.data(), rest.size())) return false;
    ++sequence_;
    constexpr size_t kEvent = 8;  // in SendEvent, after its head
    switch (static_cast<uint8_t>(head[0])) {
      case XCB_GET_GEOMETRY: sendGeometry(); break;
      case XCB_QUERY_TREE: sendReply<xcb_query_tree_reply_t>(); break;
      case XCB_TRANSLATE_COORDINATES: sendReply<xcb_translate_coordinates_reply_t>(); break;
      case XCB_INTERN_ATOM: sendReply<xcb_intern_atom_reply_t>(); break;
      case XCB_SEND_EVENT: ++(rest[kEvent] == XCB_EXPOSE ? exposed_ : configured_); break;
      default: ADD_FAILURE() << "request " << static_cast<int>(head[0]);
    }
    return true;
  }
  template <class Reply>
  void sendReply() {
    union {
      Reply reply;
      std::array<char, 32> bytes;  // of every reply
    } sent{};
    sent.reply.response_type = 1, sent.reply.sequence = sequence_;
    send(sent.bytes);
  }
  void sendGeometry() {
    union {
      xcb_get_geometry_reply_t reply;
      std::array<char, 32> bytes;
    } sent{};
    sent.reply.response_type = 1, sent.reply.sequence = sequence_;
    sent.reply.width = kWidth, sent.reply.height = kHeight;
    send(sent.bytes);
  }

  int number_ = 20000 + ::getpid() % 10000;
  int listener_ = -1, connection_ = -1;
  uint16_t sequence_ = 0;
  std::atomic<int> exposed_{0}, configured_{0};
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

TEST(XServers, EventsArriveThoughTheConnectionIsClosedAtOnce) {
  SlowServer server;
  XServers servers;
  const ShownWindow window{server.display(), kWindow};
  EXPECT_TRUE(servers.expose(window));
  servers.close();
  EXPECT_EQ(server.delivered(XCB_EXPOSE), 1);
  EXPECT_TRUE(servers.tellSize(window, true));
  servers.close();
  EXPECT_EQ(server.delivered(XCB_CONFIGURE_NOTIFY), 1);
}

TEST(XServers, SizesAreThoseOfTheServer) {
  SlowServer server;
  XServers servers;
  EXPECT_EQ(servers.sizeOf({server.display(), kWindow}), glm::ivec2(kWidth, kHeight));
}

TEST(XServers, WithoutAServerNothingIsSent) {
  XServers servers;
  const ShownWindow window{":65000", kWindow};
  EXPECT_FALSE(servers.expose(window));
  EXPECT_FALSE(servers.tellSize(window, true));
  EXPECT_EQ(servers.sizeOf(window), glm::ivec2(0));
}

}  // namespace
}  // namespace gluray::intercept
