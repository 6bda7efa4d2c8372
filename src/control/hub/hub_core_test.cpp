// Hellos, requests that clients may send, and invalid ones. answers_test.cpp tests the results of requests.
#include "control/testing/core_fixture.h"

namespace gluray::control::test {
namespace {

TEST_F(HubCoreRequests, TheHubSaysHelloAtOnce) {
  FakePeer& peer = connect();
  EXPECT_EQ(peer.one("hello"), (json{{"type", "hello"},
                                     {"version", 1},
                                     {"role", "hub"},
                                     {"pid", 4100},
                                     {"host", "node7"},
                                     {"expected", 0},
                                     {"age", 0.0},
                                     {"tcp", false}}));
}

TEST_F(HubCoreRequests, AFirstMessageThatIsNoRightHelloEndsTheConnection) {
  const json right{{"type", "hello"}, {"version", 1}, {"role", "program"}, {"pid", 1}, {"host", "a"},
                   {"name", "b"},     {"rank", 0},    {"ranks", 1},        {"job", ""}};
  std::vector<json> wrong{{{"type", "list"}, {"id", 1}}, {{"type", "hello"}}, {{"type", "error"}}};
  const std::vector<std::pair<const char*, std::vector<json>>> members{
      {"version", {0, -1, 1.5, "1", nullptr, true, json::array()}},
      {"role", {"hub", "", 1, nullptr}},
      {"pid", {0, -4, 1.5, "7", 5000000000, nullptr}},
      {"host", {1, nullptr, std::string(256, 'x')}},
      {"name", {1, nullptr, std::string(256, 'x')}},
      {"job", {1, nullptr, std::string(256, 'x')}},
      {"rank", {-1, 1, "0", 1e9}},
      {"ranks", {0, -1, "1", uint64_t{1} << 63}}};
  for (const auto& [name, values] : members)
    for (const json& value : values) {
      json message = right;
      message[name] = value;
      wrong.push_back(message);
    }
  for (const json& message : wrong) {
    FakePeer& peer = connect();
    give(peer, message);
    EXPECT_NE(peer.finished, "") << message;
    EXPECT_NE(peer.one("error").value("why", ""), "") << message;
    give(peer, right);
  }
  EXPECT_EQ(hub_.programs(), 0u) << "nothing is read from a connection that is being closed";
}

TEST_F(HubCoreRequests, HelloMustComeInTime) {
  FakePeer& peer = connect();
  EXPECT_EQ(hub_.nextDue(), now_ + std::chrono::seconds(5));
  wait(milliseconds(4999));
  EXPECT_EQ(peer.finished, "");
  wait(milliseconds(1));
  EXPECT_NE(peer.finished, "");
  EXPECT_EQ(hub_.nextDue(), HubTime::max());
}

TEST_F(HubCoreRequests, HelloComesOnce) {
  FakePeer& peer = client();
  give(peer, {{"type", "hello"}, {"version", 1}, {"role", "client"}});
  EXPECT_NE(peer.one("error")["why"], "");
  EXPECT_EQ(peer.finished, "");
}

TEST_F(HubCoreRequests, ListNamesPrograms) {
  FakePeer& peer = client();
  give(peer, {{"type", "list"}, {"id", "a"}});
  EXPECT_EQ(answered(peer, "a")["programs"], json::array());
  FakePeer& one = program();
  give(peer, {{"type", "list"}, {"id", 1}});
  EXPECT_EQ(answered(peer)["programs"], json::array({{{"program", 1},
                                                      {"pid", 102},
                                                      {"host", "node7"},
                                                      {"name", "glxgears"},
                                                      {"ranks", 1},
                                                      {"connected", 1},
                                                      {"since", 1764001000.0},
                                                      {"version", 1}}}));
  EXPECT_TRUE(hub_.hasProcess(102));
  EXPECT_FALSE(hub_.hasProcess(103));
  end(one);
  program();
  give(peer, {{"type", "list"}, {"id", 1}});
  EXPECT_EQ(answered(peer)["programs"][0]["program"], 2) << "numbers are never used twice";
}

TEST_F(HubCoreRequests, AllMayBeNone) {
  FakePeer& peer = client();
  for (const char* type : {"get", "describe", "call", "set", "undo", "redo", "observe"}) {
    give(peer, {{"type", type},
                {"id", 1},
                {"program", "all"},
                {"name", "x"},
                {"values", json::object()},
                {"what", json::array()}});
    EXPECT_EQ(answered(peer), (json{{"type", "answer"}, {"id", 1}, {"results", json::array()}})) << type;
  }
}

TEST_F(HubCoreRequests, MistakesAreAnswered) {
  FakePeer& one = program();
  FakePeer& peer = client();
  const std::string longText(65, 'x');
  const std::vector<json> wrong{
      {{"type", "get"}},
      {{"type", "get"}, {"program", 9}},
      {{"type", "get"}, {"program", "1"}},
      {{"type", "get"}, {"program", nullptr}},
      {{"type", "get"}, {"program", true}},
      {{"type", "get"}, {"program", 1.0}},
      {{"type", "get"}, {"program", -1}},
      {{"type", "get"}, {"program", std::numeric_limits<uint64_t>::max()}},
      {{"type", "get"}, {"program", {1, "all"}}},
      {{"type", "get"}, {"program", {1, {1}}}},
      {{"type", "get"}, {"program", json::object()}},
      {{"type", "get"}, {"program", 1}, {"names", "ao"}},
      {{"type", "get"}, {"program", 1}, {"names", {"ao", 1}}},
      {{"type", "set"}, {"program", 1}},
      {{"type", "set"}, {"program", 1}, {"values", {1}}},
      {{"type", "set"}, {"program", 1}, {"values", json::object()}, {"gesture", longText}},
      {{"type", "set"}, {"program", 1}, {"values", json::object()}, {"gesture", 1}},
      {{"type", "call"}, {"program", 1}},
      {{"type", "call"}, {"program", 1}, {"name", longText}},
      {{"type", "call"}, {"program", 1}, {"name", "a"}, {"arguments", {1}}},
      {{"type", "observe"}, {"program", 1}},
      {{"type", "observe"}, {"program", 1}, {"what", "state"}},
      {{"type", "observe"}, {"program", 1}, {"what", {"states"}}},
      {{"type", "observe"}, {"program", 1}, {"what", {1}}},
      {{"type", "observe"}, {"program", 1}, {"what", {"state"}}, {"every", 0.049}},
      {{"type", "observe"}, {"program", 1}, {"what", {"state"}}, {"every", "1"}},
      {{"type", "observe"}, {"program", 1}, {"what", {"state"}}, {"every", 1e300}},
      {{"type", "batch"}},
      {{"type", "batch"}, {"requests", json::object()}},
      {{"type", "batch"}, {"requests", json(257, json{{"type", "list"}})}},
      {{"type", "answer"}},
      {{"type", std::string(5000, 'x')}},
      {{"type", "nothing"}}};
  for (json request : wrong) {
    request["id"] = "an id";
    give(peer, request);
    const json answer = answered(peer, "an id");
    EXPECT_NE(answer.value("why", ""), "") << request;
    EXPECT_FALSE(answer.contains("results"));
  }
  EXPECT_EQ(one.got, std::vector<json>{}) << "programs see no wrong request";
}

TEST_F(HubCoreRequests, AnIdIsANumberOrAShortText) {
  FakePeer& peer = client();
  for (const json& id : {json(), json(true), json(std::string(65, 'x')), json::array({1}), json::object()}) {
    give(peer, {{"type", "list"}, {"id", id}});
    EXPECT_NE(peer.one("error")["why"], "") << id;
  }
  give(peer, {{"type", "list"}});
  peer.one("error");
  std::string umlauts;
  for (int i = 0; i < 64; ++i) umlauts += "\xc3\xbc";
  for (const json& id : {json(0), json(-1), json(1.5), json(umlauts), json(""), json(1e300)}) {
    give(peer, {{"type", "list"}, {"id", id}});
    answered(peer, id);
  }
  EXPECT_EQ(peer.finished, "");
}

TEST_F(HubCoreRequests, AnIdThatWaitsIsNotTakenAgain) {
  FakePeer& one = program();
  FakePeer& peer = client();
  give(peer, {{"type", "get"}, {"id", 1}, {"program", 1}});
  give(peer, {{"type", "list"}, {"id", 1}});
  peer.one("error");
  answer(one, one.one("get"), json::object());
  answered(peer);
  give(peer, {{"type", "list"}, {"id", 1}});
  answered(peer);
}

TEST_F(HubCoreRequests, SoManyRequestsMayWait) {
  program();
  FakePeer& peer = client();
  for (size_t i = 0; i < kMaxRequests; ++i) give(peer, {{"type", "get"}, {"id", i}, {"program", 1}});
  EXPECT_TRUE(peer.got.empty());
  give(peer, {{"type", "list"}, {"id", "more"}});
  EXPECT_NE(answered(peer, "more").value("why", ""), "");
  wait(milliseconds(10000));
  EXPECT_EQ(peer.takeMessages("answer").size(), kMaxRequests);
}

TEST_F(HubCoreRequests, ProgramsMayNotAsk) {
  FakePeer& one = program();
  give(one, {{"type", "set"}, {"id", 1}, {"program", "all"}, {"values", json::object()}});
  one.one("error");
  give(one, {{"type", "error"}, {"why", "I do not know that"}});
  FakePeer& peer = client();
  give(peer, {{"type", "error"}});
  EXPECT_TRUE(one.got.empty());
  EXPECT_TRUE(peer.got.empty());
}

}  // namespace
}  // namespace gluray::control::test
