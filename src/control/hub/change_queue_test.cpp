// set, undo and redo of one program: one at a time, and merged.
#include "control/testing/core_fixture.h"

namespace gluray::control::test {
namespace {

struct HubCoreChanges : HubCoreTest {
  void set(const FakePeer& from, int id, const json& values, const std::string& gesture = "") {
    json request{{"type", "set"}, {"id", id}, {"program", 1}, {"values", values}};
    if (!gesture.empty()) request["gesture"] = gesture;
    give(from, request);
  }
};

TEST_F(HubCoreChanges, OneIsInFlightAtATime) {
  FakePeer& one = program();
  FakePeer& peer = client();
  FakePeer& other = client();
  set(peer, 1, {{"a", 1}});
  set(peer, 2, {{"a", 2}});
  set(other, 1, {{"a", 3}});
  give(other, {{"type", "undo"}, {"id", 2}, {"program", 1}});
  give(other, {{"type", "redo"}, {"id", 3}, {"program", 1}});
  for (int value = 1; value <= 3; ++value) {
    const json asked = one.one("set");
    EXPECT_EQ(asked["values"], (json{{"a", value}}));
    EXPECT_FALSE(asked.contains("gesture"));
    answer(one, asked, {{"frame", value}, {"values", asked["values"]}});
  }
  const json undo = one.one("undo");
  EXPECT_EQ(undo, (json{{"type", "undo"}, {"id", undo["id"]}}));
  answer(one, undo, {{"frame", 4}, {"values", json::object()}});
  answer(one, one.one("redo"), {{"why", "nothing to make again"}});
  const std::vector<json> answers = peer.takeMessages("answer");
  ASSERT_EQ(answers.size(), 2u);
  EXPECT_EQ(answers[1]["results"][0]["frame"], 2);
  EXPECT_EQ(other.takeMessages("answer").size(), 3u);
}

TEST_F(HubCoreChanges, SetsOfOneGestureAreMerged) {
  FakePeer& one = program();
  FakePeer& peer = client();
  set(peer, 1, {{"a", 1}}, "drag");
  for (int i = 2; i <= 50; ++i) set(peer, i, {{"a", i}, {"b" + std::to_string(i % 2), i}}, "drag");
  const json first = one.one("set");
  answer(one, first, {{"frame", 1}});
  const json second = one.one("set");
  EXPECT_EQ(second["values"], (json{{"a", 50}, {"b0", 50}, {"b1", 49}}));
  EXPECT_EQ(second["gesture"], first["gesture"]);
  answer(one, second, {{"frame", 2}});
  const std::vector<json> answers = peer.takeMessages("answer");
  ASSERT_EQ(answers.size(), 50u);
  for (size_t i = 1; i < answers.size(); ++i) EXPECT_EQ(answers[i]["results"][0]["frame"], 2);
  EXPECT_TRUE(one.got.empty());
}

TEST_F(HubCoreChanges, OthersAreNotMerged) {
  FakePeer& one = program();
  FakePeer& peer = client();
  FakePeer& other = client();
  set(peer, 1, {{"a", 1}}, "x");
  set(peer, 2, {{"a", 2}}, "x");
  set(other, 3, {{"a", 3}}, "x");  // another client
  set(peer, 4, {{"a", 4}}, "x");   // not consecutive
  set(peer, 5, {{"a", 5}}, "y");   // another gesture
  set(peer, 6, {{"a", 6}});        // no gesture
  set(peer, 7, {{"a", 7}});
  std::vector<std::string> gestures;
  for (int value = 1; value <= 7; ++value) {
    const json asked = one.one("set");
    EXPECT_EQ(asked["values"]["a"], value);
    gestures.push_back(asked.value("gesture", ""));
    EXPECT_LE(gestures.back().size(), kMaxCharacters);
    answer(one, asked, {{"frame", value}});
  }
  EXPECT_EQ(gestures[0], gestures[1]);
  EXPECT_NE(gestures[1], gestures[2]) << "gestures belong to a client";
  EXPECT_EQ(gestures[1], gestures[3]);
  EXPECT_NE(gestures[3], gestures[4]);
  EXPECT_EQ(gestures[5], "");
}

TEST_F(HubCoreChanges, AWrongSetDoesNotTakeOthersWithIt) {
  FakePeer& one = program();
  FakePeer& peer = client();
  set(peer, 1, {{"a", 1}}, "x");
  for (int i = 2; i <= 4; ++i) set(peer, i, {{"a", i}}, "x");
  set(peer, 5, {{"a", 5}}, "y");
  answer(one, one.one("set"), {{"frame", 1}});
  answer(one, one.one("set"), {{"why", "a=4: no"}});  // 2, 3 and 4
  for (int value = 2; value <= 5; ++value) {
    const json asked = one.one("set");
    EXPECT_EQ(asked["values"]["a"], value);
    answer(one, asked, value == 4 ? json{{"why", "a=4: no"}} : json{{"frame", value}});
  }
  const std::vector<json> answers = peer.takeMessages("answer");
  ASSERT_EQ(answers.size(), 5u);
  for (const json& each : answers) EXPECT_EQ(each["results"][0].contains("why"), each["id"] == 4) << each;
}

TEST_F(HubCoreChanges, ThoseThatWaitTooLongFail) {
  FakePeer& one = program();
  FakePeer& peer = client();
  set(peer, 1, {{"a", 1}});
  set(peer, 2, {{"a", 2}});
  wait(milliseconds(2999));
  EXPECT_TRUE(peer.got.empty());
  wait(milliseconds(1));
  const std::vector<json> answers = peer.takeMessages("answer");
  ASSERT_EQ(answers.size(), 2u) << "the one in flight, and the one whose turn has not come";
  for (const json& each : answers) EXPECT_TRUE(each["results"][0].contains("why")) << each;
  const json asked = one.one("set");
  answer(one, asked, {{"frame", 1}});  // too late
  set(peer, 3, {{"a", 3}});
  const json next = one.one("set");
  EXPECT_EQ(next["values"]["a"], 3);
  answer(one, next, {{"frame", 2}});
  EXPECT_EQ(result(peer, 3)["frame"], 2);
}

TEST_F(HubCoreChanges, TheLastValueOfAGestureIsNotLost) {
  FakePeer& one = program();
  FakePeer& peer = client();
  set(peer, 1, {{"a", 1}});
  set(peer, 2, {{"a", 2}, {"b", 2}}, "x");
  wait(milliseconds(1000));
  set(peer, 3, {{"a", 3}}, "x");
  wait(milliseconds(2000));
  EXPECT_TRUE(result(peer, 1).contains("why"));
  const std::vector<json> asked = one.takeMessages("set");
  ASSERT_EQ(asked.size(), 2u);
  EXPECT_EQ(asked[1]["values"], (json{{"a", 3}, {"b", 2}}));
  answer(one, asked[1], {{"frame", 2}});
  const std::vector<json> answers = peer.takeMessages("answer");
  ASSERT_EQ(answers.size(), 2u);
  for (const json& each : answers) EXPECT_EQ(each["results"][0]["frame"], 2) << each;
}

TEST_F(HubCoreChanges, PartsThatWaitedTooLongDoNotFailForAnother) {
  FakePeer& one = program();
  FakePeer& peer = client();
  set(peer, 1, {{"a", 1}});
  set(peer, 2, {{"a", 2}}, "x");
  wait(milliseconds(2500));
  set(peer, 3, {{"a", 3}}, "x");
  answer(one, one.one("set"), {{"frame", 1}});
  peer.got.clear();
  const json both = one.one("set");
  wait(milliseconds(1000));
  answer(one, both, {{"why", "a=3: no"}});
  const std::string why = result(peer, 2).value("why", "");
  EXPECT_NE(why.find("turn"), std::string::npos) << why;
  answer(one, one.one("set"), {{"why", "a=3: no"}});
  EXPECT_EQ(result(peer, 3)["why"], "a=3: no");
}

TEST_F(HubCoreChanges, AProgramThatStopsAnswersAllInTime) {
  program();
  FakePeer& peer = client();
  for (int i = 0; i < 100; ++i) set(peer, i, {{"a", i}}, "x");
  wait(milliseconds(3000));
  wait(milliseconds(3000));
  EXPECT_EQ(peer.takeMessages("answer").size(), 100u);
}

TEST_F(HubCoreChanges, AClientThatGoesLeavesItsChanges) {
  FakePeer& one = program();
  FakePeer& peer = client();
  set(peer, 1, {{"a", 1}});
  set(peer, 2, {{"a", 2}});
  end(peer);
  answer(one, one.one("set"), {{"frame", 1}});
  EXPECT_EQ(one.one("set")["values"]["a"], 2);
}

}  // namespace
}  // namespace gluray::control::test
