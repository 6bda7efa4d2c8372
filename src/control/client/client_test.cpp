// The client with a fake hub whose answers the test sets, on the same io_context.
#include "control/client/client.h"

#include <asio/local/stream_protocol.hpp>
#include <asio/steady_timer.hpp>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <vector>

namespace gluray::control {
namespace {

using nlohmann::json;

constexpr double kLong = 10, kShort = 0.05;  // seconds

struct ClientTest : testing::Test {
  using Acceptor = asio::local::stream_protocol::acceptor;

  void SetUp() override {
    char name[] = "/tmp/gluray-client-XXXXXX";
    ASSERT_NE(mkdtemp(name), nullptr);
    directory = name;
  }
  void TearDown() override {
    if (peer) peer->close("the test ends");
    std::filesystem::remove_all(directory);
  }
  /// Listens; sends `hello` to each connection, and answers messages by `answer`.
  void listen(json hello = {{"type", "hello"}, {"version", 1}, {"role", "hub"}}) {
    acceptor.emplace(io, asio::local::stream_protocol::endpoint(socketIn(directory)));
    acceptor->async_accept([this, hello](const asio::error_code& error, auto socket) {
      if (error) return;
      peer = std::make_shared<Connection>(Connection::Socket(std::move(socket)));
      peer->start({[this](json&& message) {
                     heard.push_back(message);
                     if (message["type"] != "hello" && answer) answer(message);
                   },
                   [](const std::string&) {},
                   {}});
      if (!hello.is_null()) peer->send(hello);
    });
  }
  std::string connect(double seconds = kLong) { return client.connect({directory, "", ""}, seconds); }

  std::string directory;
  asio::io_context io;
  std::optional<Acceptor> acceptor;
  std::shared_ptr<Connection> peer;
  std::vector<json> heard;
  std::function<void(const json&)> answer;
  Client client{io};
};

TEST_F(ClientTest, SaysThatNoHubRuns) {
  EXPECT_EQ(connect(), "no hub runs here; start gluray panel or gluray hub");
  EXPECT_EQ(client.ask({{"type", "list"}}, kLong).why, client.whyClosed());
  EXPECT_FALSE(client.reached());
}

TEST_F(ClientTest, AsksAndGetsTheAnswerWithTheSameId) {
  listen();
  ASSERT_EQ(connect(), "");
  answer = [&](const json& request) {
    peer->send(json{{"type", "answer"}, {"id", 99}, {"results", json::array()}});
    peer->send(json{{"type", "answer"}, {"id", "text"}, {"results", json::array()}});
    peer->send(json{{"type", "news"}});
    peer->send(json{{"type", "answer"}, {"id", request["id"]}, {"results", {{{"program", 3}}}}});
  };
  for (int i = 0; i < 3; ++i) {
    const Client::Answer got = client.ask({{"type", "get"}}, kLong);
    EXPECT_EQ(got.why, "");
    EXPECT_EQ(got.message["results"][0]["program"], 3);
  }
  EXPECT_EQ(heard[0], (json{{"type", "hello"}, {"version", 1}, {"role", "client"}}));
  EXPECT_NE(heard[1]["id"], heard[2]["id"]);
}

TEST_F(ClientTest, FailuresOfRequestsAreOneLine) {
  listen();
  ASSERT_EQ(connect(), "");
  json reply;
  answer = [&](const json& request) {
    if (reply["type"] == "answer") reply["id"] = request["id"];
    peer->send(reply);
  };
  const auto why = [&](json with) {
    return reply = std::move(with), client.ask({{"type", "get"}}, kLong).why;
  };
  EXPECT_EQ(why({{"type", "answer"}, {"why", "no program has number 9"}}), "no program has number 9");
  EXPECT_EQ(why({{"type", "error"}, {"why", "get: unknown"}}), "get: unknown");
  EXPECT_EQ(why({{"type", "error"}}), "the hub refuses, and does not say why");
  EXPECT_EQ(why({{"type", "answer"}, {"why", 3}}), "the hub refuses, and does not say why");
  EXPECT_EQ(why({{"type", "answer"}}), "the hub's answer has no results");
  EXPECT_EQ(why({{"type", "answer"}, {"results", "none"}}), "the hub's answer has no results");
  EXPECT_EQ(client.whyClosed(), "");
}

TEST_F(ClientTest, EventsWaitUntilTheyAreTaken) {
  listen();
  ASSERT_EQ(connect(), "");
  answer = [&](const json& request) {
    for (int i = 0; i < 3; ++i) peer->send(json{{"type", "event"}, {"what", "state"}, {"program", i}});
    peer->send(json{{"type", "answer"}, {"id", request["id"]}, {"results", json::array()}});
  };
  ASSERT_EQ(client.ask({{"type", "observe"}}, kLong).why, "");
  for (int i = 0; i < 3; ++i) EXPECT_EQ(client.awaitEvent(kLong)["program"], i);
  EXPECT_TRUE(client.awaitEvent(kShort).is_null());
  EXPECT_EQ(client.whyClosed(), "");
}

TEST_F(ClientTest, InterruptedWaitsEnd) {
  listen();
  ASSERT_EQ(connect(), "");
  asio::steady_timer timer(io, std::chrono::milliseconds(10));
  timer.async_wait([&](const asio::error_code&) { client.interrupt(); });
  EXPECT_TRUE(client.awaitEvent(1e6).is_null());
}

TEST_F(ClientTest, AHubThatDoesNotAnswerCostsTheTimeAlone) {
  listen();
  ASSERT_EQ(connect(), "");
  EXPECT_EQ(client.ask({{"type", "list"}}, kShort).why,
            "the hub does not answer; end it, and start gluray hub");
}

TEST_F(ClientTest, AHubThatSaysNothingIsNone) {
  listen(json());
  EXPECT_EQ(connect(kShort), "the hub does not answer; end it, and start gluray hub");
}

TEST_F(ClientTest, AHubThatEndsEndsTheRequest) {
  listen();
  ASSERT_EQ(connect(), "");
  answer = [&](const json&) { peer->close("enough"); };
  const std::string why = "the connection to the hub ended: the other side closed it";
  EXPECT_EQ(client.ask({{"type", "list"}}, kLong).why, why);
  EXPECT_TRUE(client.awaitEvent(kLong).is_null());
  EXPECT_EQ(client.whyClosed(), why);
}

TEST_F(ClientTest, OtherListenersAreRefused) {
  for (const json& hello : {json{{"type", "hello"}, {"version", 0}, {"role", "hub"}},
                            json{{"type", "hello"}, {"version", "1"}, {"role", "hub"}},
                            json{{"type", "hello"}, {"version", 1}, {"role", "program"}},
                            json{{"type", "event"}, {"version", 1}, {"role", "hub"}}}) {
    std::filesystem::remove(socketIn(directory));
    listen(hello);
    EXPECT_EQ(connect(), "what listens there is no hub of GLuRay; end it, and start gluray hub") << hello;
    EXPECT_TRUE(client.reached());
  }
  std::filesystem::remove(socketIn(directory));
  listen(json{{"type", "error"}, {"why", "the hub is full"}});
  EXPECT_EQ(connect(), "the hub is full");
}

TEST_F(ClientTest, GarbageEndsTheConnection) {
  listen();
  ASSERT_EQ(connect(), "");
  answer = [&](const json&) { peer->send(std::make_shared<const std::string>("\xff{]\n")); };
  EXPECT_NE(client.ask({{"type", "list"}}, kLong).why.find("not JSON"), std::string::npos);
}

TEST_F(ClientTest, ConnectsAgain) {
  listen();
  ASSERT_EQ(connect(), "");
  std::filesystem::remove(socketIn(directory));
  listen();
  ASSERT_EQ(connect(), "");
  answer = [&](const json& request) {
    peer->send(json{{"type", "answer"}, {"id", request["id"]}, {"programs", json::array()}});
  };
  EXPECT_EQ(client.ask({{"type", "list"}}, kLong).why, "");
}

}  // namespace
}  // namespace gluray::control
