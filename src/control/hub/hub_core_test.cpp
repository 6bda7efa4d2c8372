// Hellos, requests and their mistakes, time limits and peers that go.
#include "control/hub/core_fixture.h"

namespace gluray::control::test {
namespace {

struct HubCoreRequests : HubCoreTest {};

TEST_F(HubCoreRequests, TheHubSaysHelloAtOnce) {
  FakePeer& peer = connect();
  EXPECT_EQ(peer.one("hello"), (json{{"type", "hello"},
                                     {"version", 1},
                                     {"role", "hub"},
                                     {"pid", 4100},
                                     {"host", "node7"},
                                     {"expected", 0},
                                     {"age", 0.0}}));
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
  EXPECT_EQ(hub_.next(), now_ + std::chrono::seconds(5));
  wait(milliseconds(4999));
  EXPECT_EQ(peer.finished, "");
  wait(milliseconds(1));
  EXPECT_NE(peer.finished, "");
  EXPECT_EQ(hub_.next(), HubTime::max());
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

TEST_F(HubCoreRequests, RequestsGoToProgramsAndBack) {
  FakePeer& first = program();
  FakePeer& second = program();
  FakePeer& peer = client();
  give(peer, {{"type", "get"}, {"id", 1}, {"program", json::array({2, 1, 2})}, {"names", {"ao"}}, {"x", 1}});
  const json asked = first.one("get");
  EXPECT_EQ(asked, (json{{"type", "get"}, {"id", asked["id"]}, {"names", {"ao"}}}));
  answer(first, asked, {{"values", {{"ao", 1}}}, {"program", 77}});
  EXPECT_TRUE(peer.got.empty()) << "one result is missing";
  answer(second, second.one("get"), {{"values", {{"ao", 2}}}});
  EXPECT_EQ(answered(peer)["results"], json::array({{{"program", 2}, {"values", {{"ao", 2}}}},
                                                    {{"program", 1}, {"values", {{"ao", 1}}}}}));
  give(peer, {{"type", "call"}, {"id", 2}, {"program", 1}, {"name", "still"}});
  const json call = first.one("call");
  EXPECT_EQ(call["arguments"], json::object());
  give(first, {{"type", "answer"}, {"id", call["id"]}, {"why", "no call has this name"}});
  EXPECT_EQ(result(peer, 2), (json{{"program", 1}, {"why", "no call has this name"}}));
  give(peer, {{"type", "describe"}, {"id", 3}, {"program", "all"}});
  answer(first, first.one("describe"), {{"settings", json::array()}});
  answer(second, second.one("describe"), {{"settings", json::array()}});
  EXPECT_EQ(answered(peer, 3)["results"].size(), 2u);
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
  for (size_t i = 0; i < kMostRequests; ++i) give(peer, {{"type", "get"}, {"id", i}, {"program", 1}});
  EXPECT_TRUE(peer.got.empty());
  give(peer, {{"type", "list"}, {"id", "more"}});
  EXPECT_NE(answered(peer, "more").value("why", ""), "");
  wait(milliseconds(10000));
  EXPECT_EQ(peer.take("answer").size(), kMostRequests);
}

TEST_F(HubCoreRequests, AProgramThatIsSilentDelaysNoOther) {
  FakePeer& quick = program();
  program();  // stopped
  FakePeer& peer = client();
  FakePeer& other = client();
  give(peer, {{"type", "set"}, {"id", 1}, {"program", "all"}, {"values", {{"ao", true}}}});
  give(peer, {{"type", "get"}, {"id", 2}, {"program", "all"}});
  const json set = quick.one("set");
  answer(quick, set, {{"frame", 12}, {"values", {{"ao", true}}}});
  answer(quick, quick.one("get"), {{"values", json::object()}});
  give(other, {{"type", "get"}, {"id", 1}, {"program", 1}});
  answer(quick, quick.one("get"), {{"values", json::object()}});
  answered(other);
  EXPECT_EQ(hub_.next(), now_ + std::chrono::seconds(3));
  wait(milliseconds(3000));
  EXPECT_EQ(answered(peer, 1)["results"],
            json::array({{{"program", 1}, {"frame", 12}, {"values", {{"ao", true}}}},
                         {{"program", 2}, {"why", "it did not answer within 3 s"}}}));
  wait(milliseconds(7000));
  EXPECT_EQ(answered(peer, 2)["results"][1]["why"], "it did not answer within 10 s");
  answer(quick, set, {{"frame", 13}});  // once more: ignored
  EXPECT_TRUE(peer.got.empty());
}

TEST_F(HubCoreRequests, WhatAProgramAnswersIsChecked) {
  FakePeer& one = program();
  FakePeer& other = program();
  FakePeer& peer = client();
  const std::vector<json> wrong{{{"results", 1}},
                                {{"results", {1}}},
                                {{"results", {json::object(), json::object()}}},
                                {{"why", 1}},
                                json::object()};
  for (json reply : wrong) {
    give(peer, {{"type", "get"}, {"id", 1}, {"program", 1}});
    const json asked = one.one("get");
    reply["type"] = "answer";
    for (const json& id : {json(), json("1"), json(-1), json(1.5), json(999), json(std::uint64_t{1} << 63)}) {
      reply["id"] = id;
      give(one, reply);
    }
    reply["id"] = asked["id"];
    give(other, reply);  // it was not asked
    EXPECT_TRUE(peer.got.empty());
    give(one, reply);
    EXPECT_NE(result(peer).value("why", ""), "") << reply;
  }
}

TEST_F(HubCoreRequests, APeerThatGoesEndsItsRequests) {
  FakePeer& one = program();
  FakePeer& peer = client();
  FakePeer& leaver = client();
  give(leaver, {{"type", "get"}, {"id", 1}, {"program", 1}});
  give(peer, {{"type", "get"}, {"id", 1}, {"program", 1}});
  give(peer, {{"type", "set"}, {"id", 2}, {"program", 1}, {"values", json::object()}});
  give(peer, {{"type", "undo"}, {"id", 3}, {"program", 1}});
  end(leaver);
  answer(one, one.take("get")[0], json::object());
  EXPECT_TRUE(leaver.got.empty());
  end(one);
  const std::vector<json> answers = peer.take("answer");
  ASSERT_EQ(answers.size(), 3u);
  for (const json& each : answers) EXPECT_EQ(each["results"][0]["why"], "it has ended") << each;
  give(one, {{"type", "answer"}, {"id", 1}});  // after its end
  end(one);
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

TEST_F(HubCoreRequests, ABatchIsCarriedOutInOrder) {
  FakePeer& one = program();
  FakePeer& peer = client();
  give(peer, {{"type", "batch"},
              {"id", 1},
              {"requests",
               {{{"type", "set"}, {"program", 1}, {"values", {{"ao", true}}}},
                {{"type", "get"}, {"program", 1}},
                {{"type", "batch"}, {"requests", json::array()}},
                7,
                {{"type", "list"}}}}});
  EXPECT_TRUE(one.take("get").empty()) << "the set comes first";
  answer(one, one.one("set"), {{"frame", 3}, {"values", json::object()}});
  wait(milliseconds(9000));
  answer(one, one.one("get"), {{"values", json::object()}});
  const json answers = answered(peer)["answers"];
  ASSERT_EQ(answers.size(), 5u);
  EXPECT_EQ(answers[0]["results"][0]["frame"], 3);
  EXPECT_TRUE(answers[1].contains("results"));
  EXPECT_TRUE(answers[2].contains("why"));
  EXPECT_TRUE(answers[3].contains("why"));
  EXPECT_TRUE(answers[4].contains("programs"));
  give(peer, {{"type", "batch"}, {"id", 2}, {"requests", json::array()}});
  EXPECT_EQ(answered(peer, 2)["answers"], json::array());
}

TEST_F(HubCoreRequests, AnAnswerThatIsTooLongOrTooDeepSaysSo) {
  FakePeer& one = program();
  program();
  FakePeer& peer = client();
  give(peer, {{"type", "get"}, {"id", 1}, {"program", json::array({1})}});
  answer(one, one.one("get"), {{"values", std::string(kMostBytes, 'x')}});
  EXPECT_NE(answered(peer)["why"].get<std::string>().find("1 MiB"), std::string::npos);
  json deep = json::array();
  for (int i = 0; i < 12; ++i) deep = json::array({deep});
  give(peer, {{"type", "get"}, {"id", 2}, {"program", 1}});
  answer(one, one.one("get"), {{"values", deep}});
  EXPECT_TRUE(answered(peer, 2).contains("results"));
  give(peer, {{"type", "batch"}, {"id", 3}, {"requests", {{{"type", "get"}, {"program", 1}}}}});
  answer(one, one.one("get"), {{"values", deep}});
  EXPECT_NE(answered(peer, 3)["why"].get<std::string>().find("deeper"), std::string::npos);
}

TEST_F(HubCoreRequests, ARequestThatIsTooLongForAProgramFails) {
  FakePeer& one = program();
  FakePeer& peer = client();
  give(peer, {{"type", "set"}, {"id", 1}, {"program", 1}, {"values", {{"a", std::string(kMostBytes, 'x')}}}});
  EXPECT_EQ(result(peer)["why"], "the request is too long for one message");
  EXPECT_TRUE(one.got.empty());
}

}  // namespace
}  // namespace gluray::control::test
