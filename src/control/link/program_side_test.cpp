// The program's messages to the hub: hello, values, events, calls. change_requests_test.cpp tests the
// requests that change settings.
#include "control/testing/program_side_fixture.h"

namespace gluray::control::test {
namespace {

TEST_F(ProgramSideTest, SaysHelloAndWantsOne) {
  side.begin(now);
  EXPECT_EQ(last(),
            json({{"type", "hello"}, {"version", 1}, {"role", "program"}, {"pid", 7}, {"name", "fake"}}));
  const auto refuses = [&](const json& first) {
    std::vector<std::string> why;
    ProgramSide other(program, live, source, history,
                      {[](const Connection::Line&) {}, [&](const std::string& w) { why.push_back(w); },
                       [] { return size_t{0}; }});
    other.begin(now);
    if (!first.is_null()) other.receiveMessage(first, now);
    other.passed(now + 5.1);
    return !why.empty();
  };
  EXPECT_TRUE(refuses({}));
  EXPECT_TRUE(refuses({{"type", "get"}, {"id", 1}}));
  EXPECT_TRUE(refuses({{"type", "hello"}}));
  EXPECT_TRUE(refuses({{"type", "hello"}, {"version", 0}}));
  EXPECT_TRUE(refuses({{"type", "hello"}, {"version", "1"}}));
  EXPECT_FALSE(refuses({{"type", "hello"}, {"version", 7}}));
}

TEST_F(ProgramSideTest, GetAndDescribe) {
  set({{"spp", 2}});
  EXPECT_EQ(ask({{"type", "get"}, {"names", {"spp", "ao.radius"}}})["values"]["spp"],
            json({{"value", 2}, {"layer", "live"}, {"place", ""}}));
  const json all = ask({{"type", "get"}})["values"];
  EXPECT_GT(all.size(), 50u);
  EXPECT_EQ(all["ao"], json({{"value", false}, {"layer", "built-in"}, {"place", ""}}));
  EXPECT_NE(ask({{"type", "get"}, {"names", {"none"}}}).value("why", ""), "");
  EXPECT_NE(ask({{"type", "get"}, {"names", {3}}}).value("why", ""), "");
  EXPECT_NE(ask({{"type", "get"}, {"names", 3}}).value("why", ""), "");
  const json rows = ask({{"type", "describe"}})["settings"];
  EXPECT_EQ(rows.size(), all.size());
  EXPECT_EQ(rows[0]["name"], "preset");
}

TEST_F(ProgramSideTest, StateIsSentWhileItIsObserved) {
  EXPECT_EQ(ask({{"type", "observe"}, {"what", {"state"}}, {"every", 0.5}}), json::object());
  ASSERT_EQ(sent.size(), 2u);
  for (int i = 0; i < 20; ++i)
    program.figures_.traced += 3, ++program.figures_.rasterised, frame(), pass(0.1);
  const size_t events = sent.size() - 2;
  EXPECT_GE(events, 3u);
  EXPECT_LE(events, 5u);
  const json state = last()["state"];
  EXPECT_NEAR(state["fps"].get<double>(), 10, 2);
  EXPECT_NEAR(state["traced"].get<double>(), 0.75, 0.01);
  EXPECT_EQ(state["memory"], 5);
  waiting = ProgramSide::kMuchWaiting + 1;
  const size_t before = sent.size();
  pass(1);
  EXPECT_EQ(sent.size(), before) << "the hub reads slowly";
  waiting = 0;
  ask({{"type", "observe"}, {"what", json::array()}});
  pass(5);
  EXPECT_EQ(sent.size(), before + 1);
  EXPECT_GT(side.nextDue(now), now + 1e9);
}

TEST_F(ProgramSideTest, SettingsAreSentWhenTheyChange) {
  set({{"spp", 2}});
  ask({{"type", "observe"}, {"what", {"settings"}}});
  EXPECT_EQ(last(), json({{"type", "event"},
                          {"what", "settings"},
                          {"values", {{"spp", {{"value", 2}, {"layer", "live"}, {"place", ""}}}}},
                          {"undo", 1},
                          {"redo", 0}}));
  const size_t before = sent.size();
  pass(1), pass(1);
  EXPECT_EQ(sent.size(), before);
  live.change(LiveSettings::Changes{{"ao", "on"}});  // as from a file
  pass(1);
  EXPECT_EQ(last()["values"].size(), 1u);
  EXPECT_EQ(last()["values"]["ao"]["value"], true);
  receiveMessage({{"type", "undo"}, {"id", 4}});
  EXPECT_EQ(last()["values"]["spp"]["layer"], "built-in");
  EXPECT_EQ(last()["redo"], 1);
}

TEST_F(ProgramSideTest, ObserveChecksWhatItIsAsked) {
  const auto why = [&](const json& what, const json& every = 1) {
    return ask({{"type", "observe"}, {"what", what}, {"every", every}}).value("why", "");
  };
  EXPECT_NE(why("state"), "");
  EXPECT_NE(why(json::array({"state"}), "1"), "");
  EXPECT_EQ(why(json::array({"state"}), -3), "");
  EXPECT_GE(side.nextDue(now), now + 0.9 * Observed::kMinInterval);
  EXPECT_EQ(why(json::array({"thumbnail"})), "");
  EXPECT_EQ(why(json::array({"state", "thumbnail", "later", 7})), "");
}

TEST_F(ProgramSideTest, Calls) {
  EXPECT_EQ(ask({{"type", "call"}, {"name", "double"}, {"arguments", {{"of", 4}}}}), json({{"value", 8}}));
  EXPECT_EQ(ask({{"type", "call"}, {"name", "sing"}})["why"], "no call is named sing");
  EXPECT_NE(ask({{"type", "call"}, {"name", 3}}).value("why", ""), "");
  EXPECT_NE(ask({{"type", "call"}, {"name", "double"}, {"arguments", 3}}).value("why", ""), "");
  EXPECT_NE(ask({{"type", "call"}, {"name", "double"}, {"arguments", {{"of", "x"}}}}).value("why", ""), "")
      << "throws";
}

TEST_F(ProgramSideTest, CallsWaitForAFrame) {
  const json late{{"type", "call"}, {"name", "late"}, {"arguments", {{"of", 4}}}};
  pass(1);
  EXPECT_EQ(ask(late), json());
  pass(0);
  EXPECT_EQ(program.woken, 1);
  EXPECT_LT(side.nextDue(now), now + 0.1);
  program.drawn = true, pass(0.1);
  EXPECT_EQ(resultOf(last()), json({{"value", 8}}));
  EXPECT_EQ(sent.size(), 1u);
  program.drawn = false;
  EXPECT_EQ(ask(late), json());
  for (int i = 0; i < 100; ++i) pass(0.09);
  EXPECT_NE(resultOf(last()).value("why", "").find("no frame for 8 seconds"), std::string::npos);
  EXPECT_EQ(sent.size(), 2u);
}

TEST_F(ProgramSideTest, NonsenseIsAnswered) {
  EXPECT_NE(ask({{"type", "dance"}}).value("why", ""), "");
  for (const json& id : {json(), json::object(), json(true), json(std::string(500, 'x'))}) {
    receiveMessage({{"type", "get"}, {"id", id}});
    EXPECT_EQ(last()["type"], "error") << id;
  }
  receiveMessage({{"type", "set"}});
  EXPECT_EQ(last()["type"], "error");
  const size_t before = sent.size();
  for (const char* type : {"error", "answer", "event", "hello"}) receiveMessage({{"type", type}, {"id", 1}});
  EXPECT_EQ(sent.size(), before);
  EXPECT_TRUE(finished.empty());
}

}  // namespace
}  // namespace gluray::control::test
