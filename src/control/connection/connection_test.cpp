#include "control/connection/connection.h"

#include <asio/io_context.hpp>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/socket.h>
#include <unistd.h>

namespace gluray::control {
namespace {

using nlohmann::json;

/// A connection whose other end is a plain socket.
struct ConnectionTest : testing::Test {
  void SetUp() override {
    int ends[2];
    ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends), 0);
    other = ends[1];
    protocol = {AF_UNIX, 0};
    socket = ends[0];
  }
  void TearDown() override {
    if (connection) connection->close("the test ends");
    connection.reset();
    io.restart(), io.poll();
    if (other >= 0) ::close(other);
  }
  void start(int messagesPerSecond = 0) {
    connection = std::make_shared<Connection>(Connection::Socket(io, protocol, socket), messagesPerSecond);
    connection->start({[this](json&& message) { messages.push_back(std::move(message)); },
                       [this](const std::string& why) { closed.push_back(why); },
                       {}});
  }
  void give(const std::string& bytes) {
    ASSERT_EQ(write(other, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
    io.restart(), io.poll();
  }
  std::string got() {
    io.restart(), io.poll();
    char bytes[1 << 16];
    const ssize_t size = recv(other, bytes, sizeof bytes, MSG_DONTWAIT);
    return {bytes, static_cast<size_t>(std::max<ssize_t>(size, 0))};
  }

  asio::io_context io;
  Connection::Socket::protocol_type protocol{AF_UNIX, 0};
  int socket = -1, other = -1;
  std::shared_ptr<Connection> connection;
  std::vector<json> messages;
  std::vector<std::string> closed;
};

TEST_F(ConnectionTest, ReadsMessagesThatComeInPieces) {
  start();
  give(R"({"type":"li)");
  EXPECT_TRUE(messages.empty());
  give("st\",\"id\":1}\n{\"type\":\"get\"}\n{");
  ASSERT_EQ(messages.size(), 2u);
  EXPECT_EQ(messages[0]["id"], 1);
  EXPECT_EQ(messages[1]["type"], "get");
  EXPECT_TRUE(connection->open());
}

TEST_F(ConnectionTest, SendsInOrderAlsoWhatCameBeforeItStarted) {
  connection = std::make_shared<Connection>(Connection::Socket(io, protocol, socket));
  for (int i = 0; i < 200; ++i) connection->send(json{{"type", "a"}, {"i", i}});
  EXPECT_GT(connection->waiting(), 0u);
  connection->start({[](json&&) {}, [](const std::string&) {}, {}});
  std::string expected;
  for (int i = 0; i < 200; ++i) expected += lineOf(json{{"type", "a"}, {"i", i}});
  EXPECT_EQ(got(), expected);
  EXPECT_EQ(connection->waiting(), 0u);
}

TEST_F(ConnectionTest, AnswersWhatIsNoMessageAndCloses) {
  start();
  give("{}\n{\"type\":\"list\"}\n");
  EXPECT_EQ(got(), "{\"type\":\"error\",\"why\":\"the message has no type\"}\n");
  EXPECT_TRUE(messages.empty());
  EXPECT_EQ(closed, std::vector<std::string>{"the message has no type"});
  EXPECT_FALSE(connection->open());
}

TEST_F(ConnectionTest, SaysOnceThatTheOtherSideHasClosed) {
  start();
  ::close(std::exchange(other, -1));
  io.restart(), io.poll();
  EXPECT_EQ(closed, std::vector<std::string>{"the other side closed it"});
  connection->send(json{{"type", "late"}});
  EXPECT_EQ(connection->waiting(), 0u);
}

TEST_F(ConnectionTest, ClosesWhenThePeerDoesNotRead) {
  start();
  const auto line = sharedLine(json{{"type", "event"}, {"text", std::string(100000, 'x')}});
  for (int i = 0; i < 100 && connection->open(); ++i) connection->send(line), io.restart(), io.poll();
  EXPECT_EQ(closed, std::vector<std::string>{"it does not read what is sent to it"});
}

TEST_F(ConnectionTest, ReadsNoMoreThanItsRateAllows) {
  start(10);
  std::string many;
  for (int i = 0; i < 25; ++i) many += "{\"type\":\"list\"}\n";
  give(many);
  EXPECT_LE(messages.size(), 20u);  // 10, or 20 if a second ends just then
  const auto begin = std::chrono::steady_clock::now();
  while (messages.size() < 25 && std::chrono::steady_clock::now() - begin < std::chrono::seconds(10))
    io.restart(), io.run_for(std::chrono::milliseconds(100));
  EXPECT_EQ(messages.size(), 25u);
}

TEST_F(ConnectionTest, FinishSendsWhatWaits) {
  start();
  connection->send(json{{"type", "bye"}});
  connection->finish("done");
  EXPECT_EQ(got(), "{\"type\":\"bye\"}\n");
  EXPECT_EQ(closed, std::vector<std::string>{"done"});
}

TEST_F(ConnectionTest, AHandlerThatThrowsEndsThisConnectionAlone) {
  connection = std::make_shared<Connection>(Connection::Socket(io, protocol, socket));
  connection->start({[](json&&) { throw std::bad_alloc(); },
                     [this](const std::string& why) { closed.push_back(why); },
                     {}});
  EXPECT_NO_THROW(give("{\"type\":\"a\"}\n{\"type\":\"b\"}\n"));
  EXPECT_EQ(closed.size(), 1u);
  EXPECT_FALSE(connection->open());
}

TEST_F(ConnectionTest, ADescriptorIsClosedWhereNoSocketIsMade) {
  connection = std::make_shared<Connection>(Connection::Socket(io, protocol, socket));
  EXPECT_THROW(socketOf(io, AF_UNIX, 0, Descriptor(-2)), std::exception);
  int ends[2];
  ASSERT_EQ(pipe2(ends, O_CLOEXEC), 0);
  { const Descriptor owner(ends[0]); }
  EXPECT_EQ(fcntl(ends[0], F_GETFD), -1);
  Connection::Socket made = socketOf(io, AF_UNIX, 0, Descriptor(ends[1]));
  EXPECT_EQ(made.native_handle(), ends[1]);
}

TEST_F(ConnectionTest, AHandlerMayCloseIt) {
  connection = std::make_shared<Connection>(Connection::Socket(io, protocol, socket));
  int seen = 0;
  connection->start({[&](json&&) { ++seen, connection->close("enough"); }, [](const std::string&) {}, {}});
  give("{\"type\":\"a\"}\n{\"type\":\"b\"}\n");
  EXPECT_EQ(seen, 1);
}

}  // namespace
}  // namespace gluray::control
