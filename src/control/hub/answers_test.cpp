// Requests that are forwarded to programs: answers, time limits, and peers that disconnect.
#include "control/testing/core_fixture.h"

namespace gluray::control::test {
namespace {

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

TEST_F(HubCoreRequests, AProgramThatIsSilentDelaysNoOther) {
  FakePeer& quick = program();
  program();  // does not answer
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
  EXPECT_EQ(hub_.nextDue(), now_ + std::chrono::seconds(3));
  wait(milliseconds(3000));
  EXPECT_EQ(answered(peer, 1)["results"],
            json::array({{{"program", 1}, {"frame", 12}, {"values", {{"ao", true}}}},
                         {{"program", 2}, {"why", "it did not answer within 3 s"}}}));
  wait(milliseconds(7000));
  EXPECT_EQ(answered(peer, 2)["results"][1]["why"], "it did not answer within 10 s");
  answer(quick, set, {{"frame", 13}});  // a second answer is ignored
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
    give(other, reply);  // the request was not sent to it
    EXPECT_TRUE(peer.got.empty());
    give(one, reply);
    EXPECT_NE(result(peer).value("why", ""), "") << reply;
  }
}

TEST_F(HubCoreRequests, IdsAreTheSameWhereTheyAreWrittenAlike) {
  FakePeer& one = program();
  FakePeer& peer = client();
  const json most = std::uint64_t{18446744073709551615u};  // as a signed number it would be -1
  const std::vector<json> ids{-1, most, 18446744073709551615.0, 1, 1.0, "1"};
  for (const json& id : ids) give(peer, {{"type", "get"}, {"id", id}, {"program", 1}});
  EXPECT_TRUE(peer.got.empty()) << json(peer.got);
  give(peer, {{"type", "get"}, {"id", most}, {"program", 1}});
  EXPECT_NE(peer.one("error").value("why", ""), "");
  for (const json& asked : one.takeMessages("get")) answer(one, asked, {{"values", json::object()}});
  std::vector<std::string> answered;
  for (const json& message : peer.takeMessages("answer")) answered.push_back(message["id"].dump());
  EXPECT_EQ(answered, (std::vector<std::string>{"-1", "18446744073709551615", "1.8446744073709552e+19", "1",
                                                "1.0", "\"1\""}));
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
  answer(one, one.takeMessages("get")[0], json::object());
  EXPECT_TRUE(leaver.got.empty());
  end(one);
  const std::vector<json> answers = peer.takeMessages("answer");
  ASSERT_EQ(answers.size(), 3u);
  for (const json& each : answers) EXPECT_EQ(each["results"][0]["why"], "it has ended") << each;
  give(one, {{"type", "answer"}, {"id", 1}});  // after its end
  end(one);
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
  EXPECT_TRUE(one.takeMessages("get").empty()) << "the set comes first";
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
  answer(one, one.one("get"), {{"values", std::string(kMaxBytes, 'x')}});
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
  give(peer, {{"type", "set"}, {"id", 1}, {"program", 1}, {"values", {{"a", std::string(kMaxBytes, 'x')}}}});
  EXPECT_EQ(result(peer)["why"], "the request is too long for one message");
  EXPECT_TRUE(one.got.empty());
}

}  // namespace
}  // namespace gluray::control::test
