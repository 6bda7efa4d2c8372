// Which events clients receive, how often, and how slow clients are treated.
#include "control/testing/core_fixture.h"

namespace gluray::control::test {
namespace {

struct HubCoreObservers : HubCoreTest {
  void observe(FakePeer& from, const json& program, const json& what, double every = 0.05) {
    give(from, {{"type", "observe"}, {"id", "o"}, {"program", program}, {"what", what}, {"every", every}});
    for (const json& answer : from.takeMessages("answer"))
      EXPECT_EQ(answer, (json{{"type", "answer"}, {"id", "o"}, {"results", json::array()}}));
  }
  void state(const FakePeer& program, int frame) {
    give(program, {{"type", "event"}, {"what", "state"}, {"state", {{"frame", frame}}}});
  }
  static std::vector<int> frames(FakePeer& peer) {
    std::vector<int> frames;
    for (const json& event : peer.takeMessages("event")) frames.push_back(event["state"]["frame"].get<int>());
    return frames;
  }
};

TEST_F(HubCoreObservers, AProgramIsAskedForWhatAnyClientWants) {
  FakePeer& one = program();
  FakePeer& peer = client();
  FakePeer& other = client();
  observe(peer, 1, {"state"}, 2);
  json asked = one.one("observe");
  EXPECT_EQ(asked, (json{{"type", "observe"}, {"id", asked["id"]}, {"what", {"state"}}, {"every", 2.0}}));
  observe(other, "all", {"thumbnail"}, 0.5);
  asked = one.one("observe");
  EXPECT_EQ(asked["what"], json::array({"state", "thumbnail"}));
  EXPECT_EQ(asked["every"], 0.5);
  observe(other, "all", {"thumbnail"}, 0.5);
  EXPECT_TRUE(one.got.empty()) << "nothing has changed";
  end(other);
  EXPECT_EQ(one.one("observe")["what"], json::array({"state"}));
  observe(peer, 1, json::array());
  asked = one.one("observe");
  EXPECT_EQ(asked["what"], json::array());
  state(one, 1);
  EXPECT_TRUE(peer.got.empty());
}

TEST_F(HubCoreObservers, ThumbnailsHaveTheLargestSizeThatIsWanted) {
  FakePeer& one = program();
  FakePeer& peer = client();
  FakePeer& other = client();
  observe(peer, 1, {"thumbnail"});
  EXPECT_EQ(one.one("observe")["size"], 256);
  give(other, {{"type", "observe"}, {"id", 1}, {"program", 1}, {"what", {"thumbnail"}}, {"size", 300}});
  EXPECT_EQ(one.one("observe")["size"], 300);
  end(other);
  EXPECT_EQ(one.one("observe")["size"], 256);
  for (const json& size : {json(15), json(513), json("64"), json(20.5)}) {
    peer.takeMessages("answer");
    give(peer, {{"type", "observe"}, {"id", 1}, {"program", 1}, {"what", {"thumbnail"}}, {"size", size}});
    EXPECT_NE(peer.one("answer").value("why", ""), "") << size;
  }
}

TEST_F(HubCoreObservers, ClientsThatComeLaterGetTheNewestThumbnail) {
  FakePeer& one = program();
  FakePeer& peer = client();
  FakePeer& other = client();
  observe(peer, 1, {"thumbnail"});
  give(one, {{"type", "event"}, {"what", "thumbnail"}, {"width", 4}});
  EXPECT_EQ(peer.one("event")["width"], 4);
  one.got.clear();
  observe(other, 1, {"thumbnail"});
  EXPECT_TRUE(one.got.empty()) << "nothing has changed for it";
  EXPECT_EQ(other.one("event")["width"], 4);
  observe(peer, 1, json::array()), observe(other, 1, json::array());
  observe(other, 1, {"thumbnail"});
  EXPECT_TRUE(other.takeMessages("event").empty()) << "it may be old; the program is asked";
}

TEST_F(HubCoreObservers, EventsGoToThoseThatWantThem) {
  FakePeer& one = program();
  FakePeer& two = program();
  FakePeer& peer = client();
  FakePeer& other = client();
  FakePeer& third = client();
  observe(peer, 1, {"state"});
  observe(other, "all", {"state"});
  state(one, 5), state(two, 6);
  EXPECT_EQ(peer.one("event"),
            (json{{"type", "event"}, {"what", "state"}, {"program", 1}, {"state", {{"frame", 5}}}}));
  EXPECT_EQ(frames(other), (std::vector<int>{5, 6}));
  EXPECT_TRUE(third.got.empty());
  for (const json& what : {json("programs"), json("nothing"), json(1), json()})
    give(one, {{"type", "event"}, {"what", what}});
  give(one, {{"type", "event"}});
  EXPECT_TRUE(other.got.empty());
  FakePeer& later = program();
  EXPECT_EQ(later.one("observe")["what"], json::array({"state"})) << "all: also those that come later";
}

TEST_F(HubCoreObservers, EachClientGetsStatesAsOftenAsItAsked) {
  FakePeer& one = program();
  FakePeer& often = client();
  FakePeer& seldom = client();
  observe(often, 1, {"state"}, 0.05);
  observe(seldom, 1, {"state"}, 1);
  for (int frame = 0; frame < 40; ++frame) state(one, frame), wait(milliseconds(50));
  EXPECT_EQ(frames(often).size(), 40u);
  EXPECT_EQ(frames(seldom), (std::vector<int>{0, 19, 39})) << "the newest, each second";
}

TEST_F(HubCoreObservers, ASlowClientGetsTheNewest) {
  FakePeer& one = program();
  FakePeer& two = program();
  FakePeer& peer = client();
  observe(peer, "all", {"state", "settings"});
  for (const json& asked : one.takeMessages("observe")) answer(one, asked, json::object());
  peer.waiting = kBehind + 1;
  for (int frame = 0; frame < 100; ++frame)
    state(two, frame + 1000), state(one, frame), wait(milliseconds(50));
  EXPECT_TRUE(peer.got.empty());
  EXPECT_EQ(hub_.nextDue(), HubTime::max()) << "nothing is due before it reads";
  give(one, {{"type", "event"}, {"what", "settings"}, {"values", {{"ao", 1}}}});
  EXPECT_EQ(peer.one("event")["values"], (json{{"ao", 1}})) << "changes are never left out";
  peer.waiting = 0;
  hub_.drained(peer.connection, now_);
  EXPECT_EQ(frames(peer), (std::vector<int>{1099, 99})) << "those that wait longest come first";
  hub_.drained(peer.connection, now_);
  EXPECT_TRUE(peer.got.empty());
}

TEST_F(HubCoreObservers, SettingsBeginWithAllOfThem) {
  FakePeer& one = program();
  FakePeer& first = client();
  FakePeer& second = client();
  const auto settings = [&](int value) {
    give(one,
         {{"type", "event"}, {"what", "settings"}, {"values", {{"ao", value}}}, {"undo", 1}, {"redo", 0}});
  };
  observe(first, 1, {"settings"});
  answer(one, one.one("observe"), json::object());
  settings(1);
  EXPECT_EQ(first.one("event")["undo"], 1);
  observe(second, 1, {"settings"});
  settings(2);  // sent before the program received the second observe
  EXPECT_TRUE(second.got.empty());
  answer(one, one.one("observe"), json::object());
  settings(3);
  EXPECT_EQ(second.one("event")["values"]["ao"], 3);
  EXPECT_EQ(first.takeMessages("event").size(), 2u);
  observe(second, 1, {"state"});
  settings(4);
  EXPECT_TRUE(second.got.empty());
}

TEST_F(HubCoreObservers, ProgramsAreToldWhenTheyChange) {
  FakePeer& peer = client();
  observe(peer, "all", {"programs"});
  EXPECT_EQ(peer.one("event"), (json{{"type", "event"}, {"what", "programs"}, {"programs", json::array()}}));
  wait(milliseconds(50));
  for (int i = 0; i < 200; ++i) program();
  const std::vector<json> at = peer.takeMessages("event");
  EXPECT_LE(at.size(), 1u) << "not one for each";
  wait(milliseconds(50));
  EXPECT_EQ(peer.one("event")["programs"].size(), 200u);
  observe(peer, 3, {"state"});
  end(*peers_[5]);
  wait(milliseconds(100));
  EXPECT_EQ(peer.takeMessages("event").back()["programs"].size(), 199u)
      << "lasts until an observe of all without it";
  observe(peer, "all", json::array());
  program();
  wait(milliseconds(100));
  EXPECT_TRUE(peer.got.empty());
}

TEST_F(HubCoreObservers, TheListComesBeforeEventsOfNewPrograms) {
  FakePeer& peer = client();
  observe(peer, "all", {"programs", "settings", "state"});
  program();
  wait(milliseconds(1000));
  peer.got.clear();
  program();
  FakePeer& second = program();
  FakePeer& third = program();  // within the 50 ms after a list
  answer(second, second.one("observe"), json::object());
  peer.got.clear();
  give(second, {{"type", "event"}, {"what", "settings"}, {"values", json::object()}});
  std::vector<json> events = peer.takeMessages("event");
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0]["programs"].size(), 4u);
  EXPECT_EQ(events[1]["what"], "settings");
  state(third, 1), state(second, 1);
  EXPECT_EQ(frames(peer), (std::vector<int>{1, 1})) << "the list has not changed since";
  wait(milliseconds(1000));
  EXPECT_TRUE(peer.got.empty());
}

TEST_F(HubCoreObservers, AListIsMadeWhenItIsSent) {
  FakePeer& peer = client();
  observe(peer, "all", {"programs", "state"});
  wait(milliseconds(1000));
  peer.got.clear();
  peer.waiting = kBehind + 1;
  FakePeer& one = program();
  wait(milliseconds(10));
  FakePeer& two = program();
  end(one);
  state(two, 7);
  EXPECT_TRUE(peer.got.empty());
  peer.waiting = 0;
  hub_.drained(peer.connection, now_);
  const std::vector<json> events = peer.takeMessages("event");
  ASSERT_EQ(events.size(), 2u);
  ASSERT_EQ(events[0]["programs"].size(), 1u) << events[0];
  EXPECT_EQ(events[0]["programs"][0]["program"], 2);
  EXPECT_EQ(events[1]["state"]["frame"], 7);
  wait(milliseconds(1000));
  EXPECT_TRUE(peer.got.empty());
}

}  // namespace
}  // namespace gluray::control::test
