// What a program says to the hub, with a fake program and a fake clock.
#include "control/link/program_side.h"

#include "base/clock.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gluray::control {
namespace {

using nlohmann::json;

struct FakeProgram final : ControlledProgram {
  json identity() override { return {{"pid", 7}, {"name", "fake"}}; }
  Figures figures() override { return figures_; }
  json state() override { return {{"memory", 5}}; }
  Called call(const std::string& name, const json& arguments, json& value, std::string& why) override {
    if (name == "late" && !drawn) return Called::later;
    if (name != "double" && name != "late") why = "no call is named " + name;
    if (arguments.contains("of")) value = 2 * arguments["of"].get<int>();
    return Called::done;
  }
  void wake() noexcept override { ++woken; }

  Figures figures_;
  int woken = 0;
  bool drawn = false;  // what the call "late" needs
};

struct ProgramSideTest : testing::Test {
  ProgramSideTest() {
    Sources sources;
    sources.variables.emplace();
    live.start(sources);
    frame();
    side.begin(now);
    take({{"type", "hello"}, {"version", 1}, {"role", "hub"}});
    sent.clear();
  }
  /// A frame is drawn and shown.
  void frame() {
    source.take(version), source.beginFrame();
    source.endFrame(), source.take(version);
  }
  void begin() { source.take(version), source.beginFrame(); }
  void take(const json& message) { side.take(message, now); }
  void pass(double seconds) { side.passed(now += seconds); }
  /// The newest message.
  json last() const { return sent.empty() ? json() : sent.back(); }
  /// The result of a request that is answered at once.
  json ask(json message) {
    const size_t before = sent.size();
    message["id"] = 1;
    take(message);
    return sent.size() == before ? json() : resultOf(sent[before]);
  }
  static json resultOf(const json& message) {
    if (message.contains("why")) return {{"why", message["why"]}};
    return message["results"].empty() ? json::object() : message["results"][0];
  }
  static json setting(const json& values) { return {{"type", "set"}, {"values", values}}; }
  /// Sets at once, and begins a frame.
  json set(const json& values, const std::string& gesture = "") {
    json message = setting(values);
    message["id"] = 9;
    if (!gesture.empty()) message["gesture"] = gesture;
    take(message);
    begin(), pass(0.01), source.endFrame();
    return resultOf(last());
  }
  json step(const char* type) {
    take({{"type", type}, {"id", 9}});
    begin(), pass(0.01), source.endFrame();
    return resultOf(last());
  }

  double now = nowSeconds() + 1000;
  SettingsSource source;
  LiveSettings live{source, [](const std::string&) {}};
  uint64_t version = 0;  // of a context
  FakeProgram program;
  std::vector<json> sent;
  std::vector<std::string> finished;
  SettingsHistory history;
  ProgramSide side{program,
                   live,
                   source,
                   history,
                   {[this](const Connection::Line& line) { sent.push_back(json::parse(*line)); },
                    [this](const std::string& why) { finished.push_back(why); }, [this] { return waiting; }}};
  size_t waiting = 0;
};

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
    if (!first.is_null()) other.take(first, now);
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

TEST_F(ProgramSideTest, SetIsAnsweredWhenAFrameHasTheValues) {
  EXPECT_EQ(ask(setting({{"ao", true}, {"ao.samples", 32}})), json());
  source.endFrame(), source.take(version);
  pass(0.01);
  EXPECT_TRUE(sent.empty()) << "taken, but nothing is drawn";
  source.beginFrame();
  pass(0.01);
  EXPECT_EQ(last(), json({{"type", "answer"},
                          {"id", 1},
                          {"results", {{{"frame", 3}, {"values", {{"ao", true}, {"ao.samples", 32}}}}}}}));
  EXPECT_TRUE(source.current()->ao.enabled);
  EXPECT_EQ(set({{"ao", nullptr}})["values"]["ao"], false);
}

TEST_F(ProgramSideTest, ProgramsThatDrawNothingAreAskedToAndAnsweredFor) {
  ask(setting({{"ao", true}}));
  EXPECT_EQ(program.woken, 1);
  pass(0.1);
  EXPECT_EQ(program.woken, 1);
  pass(0.1);
  EXPECT_EQ(program.woken, 2) << "the first frame may have begun before";
  pass(0.31);
  EXPECT_EQ(resultOf(last()), json({{"frame", nullptr}, {"values", {{"ao", true}}}}));
  begin();
  const size_t before = sent.size();
  pass(1);
  EXPECT_EQ(sent.size(), before);
}

TEST_F(ProgramSideTest, ProgramsThatDrawAreNotAsked) {
  now = nowSeconds();
  source.endFrame();
  ask(setting({{"ao", true}}));
  pass(0.05);
  EXPECT_EQ(program.woken, 0);
  pass(0.1);
  EXPECT_EQ(program.woken, 1);
}

TEST_F(ProgramSideTest, WrongValuesChangeNothing) {
  const auto why = [&](const json& values) { return ask(setting(values)).value("why", ""); };
  EXPECT_EQ(why({{"ao", true}, {"spp", 0}}), "spp=0: use a number from 1 (the centre) to 1024");
  EXPECT_EQ(why({{"aoo", true}}), "no setting is called 'aoo'; did you mean 'ao'?");
  EXPECT_NE(why({{"ao", json::object()}}), "");
  EXPECT_NE(why({{"report", "/tmp/x"}}), "");
  EXPECT_NE(why({{"explain", 3}}), "");
  EXPECT_NE(why({{"environment", std::string(100000, 'x')}}), "");
  EXPECT_NE(why(json::array()), "");
  EXPECT_NE(why(nullptr), "");
  EXPECT_NE(ask({{"type", "set"}}).value("why", ""), "");
  EXPECT_NE(ask({{"type", "set"}, {"values", json::object()}, {"gesture", 3}}).value("why", ""), "");
  EXPECT_EQ(*source.current(), Settings{});
  EXPECT_NE(ask({{"type", "undo"}}).value("why", ""), "");
}

TEST_F(ProgramSideTest, UndoAndRedo) {
  set({{"spp", 2}}), set({{"spp", 3}, {"ao", true}});
  for (int i = 4; i < 9; ++i) set({{"spp", i}}, "drag");
  EXPECT_EQ(step("undo")["values"], json({{"spp", 3}}));
  EXPECT_EQ(step("undo")["values"], json({{"spp", 2}, {"ao", false}}));
  EXPECT_EQ(step("redo")["values"], json({{"spp", 3}, {"ao", true}}));
  EXPECT_EQ(step("redo")["values"], json({{"spp", 8}}));
  EXPECT_NE(step("redo").value("why", ""), "");
  step("undo"), step("undo"), step("undo");
  EXPECT_EQ(*source.current(), Settings{});
  EXPECT_NE(step("undo").value("why", ""), "");
}

TEST_F(ProgramSideTest, HeldChangesCountFromTheirFrame) {
  json hold = setting({{"spp", 4}});
  hold["id"] = "a", hold["hold"] = true;
  now = nowSeconds();
  begin(), take(hold);
  json at = resultOf(last());
  EXPECT_EQ(at["frame"], 2);
  EXPECT_EQ(at["drawing"], true);
  EXPECT_TRUE(at["age"].is_number() && at["period"].is_number()) << at;
  EXPECT_EQ(ask({{"type", "draw"}, {"of", "a"}}).value("why", ""), "what is held was not applied");
  EXPECT_EQ(ask({{"type", "apply"}, {"of", "a"}, {"frame", 4}}), json({{"frame", 4}, {"late", false}}));
  EXPECT_EQ(ask({{"type", "draw"}, {"of", "a"}}), json());
  const size_t before = sent.size();
  source.endFrame(), begin(), pass(0.01);
  EXPECT_EQ(source.current()->spp, 1);
  EXPECT_EQ(sent.size(), before);
  source.endFrame(), begin(), pass(0.01);
  EXPECT_EQ(source.current()->spp, 4);
  EXPECT_EQ(resultOf(last()), json({{"frame", 4}, {"values", {{"spp", 4}}}}));
  EXPECT_EQ(step("undo")["values"]["spp"], 1);
}

TEST_F(ProgramSideTest, HeldChangesMayBeLateDroppedOrForgotten) {
  json hold = setting({{"spp", 4}});
  hold["hold"] = true;
  ask(hold);
  frame(), frame();
  EXPECT_EQ(ask({{"type", "apply"}, {"of", 1}, {"frame", 2}}), json({{"frame", 2}, {"late", true}}));
  EXPECT_EQ(source.current()->spp, 4);
  hold["values"]["spp"] = 5;
  ask(hold);
  EXPECT_EQ(ask({{"type", "drop"}, {"of", 1}}), json::object());
  EXPECT_EQ(ask({{"type", "apply"}, {"of", 1}, {"frame", 2}}).value("why", ""),
            "nothing is held under this number");
  ask(hold);
  pass(5.1);
  EXPECT_NE(ask({{"type", "apply"}, {"of", 1}, {"frame", 2}}).value("why", ""), "");
  hold["values"]["spp"] = 0;
  EXPECT_NE(ask(hold).value("why", ""), "");
  for (int i = 0; i < 100; ++i) hold["values"]["spp"] = 2, hold["id"] = i, take(hold);
  for (const json& frame : {json("x"), json(-1), json(1e300), json()}) {
    json apply{{"type", "apply"}, {"of", 99}, {"frame", frame}};
    EXPECT_NE(ask(apply).value("why", ""), "") << frame;
  }
  EXPECT_EQ(source.current()->spp, 4);
}

TEST_F(ProgramSideTest, IdleRanksTakeTheValuesInTheFrameThatTheyAreAskedFor) {
  json undo{{"type", "set"}, {"values", {{"spp", 4}}}, {"hold", true}};
  const json at = ask(undo);
  EXPECT_EQ(at["frame"], 1);
  EXPECT_EQ(at["drawing"], false);
  ask({{"type", "apply"}, {"of", 1}, {"frame", 2}});
  const int before = program.woken;
  ask({{"type", "draw"}, {"of", 1}});
  EXPECT_EQ(program.woken, before + 1);
  begin(), pass(0.01);
  EXPECT_EQ(resultOf(last())["frame"], 2);
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
  EXPECT_GT(side.next(now), now + 1e9);
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
  take({{"type", "undo"}, {"id", 4}});
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
  EXPECT_GE(side.next(now), now + 0.9 * Observed::kLeastEvery);
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
  EXPECT_LT(side.next(now), now + 0.1);
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
    take({{"type", "get"}, {"id", id}});
    EXPECT_EQ(last()["type"], "error") << id;
  }
  take({{"type", "set"}});
  EXPECT_EQ(last()["type"], "error");
  const size_t before = sent.size();
  for (const char* type : {"error", "answer", "event", "hello"}) take({{"type", type}, {"id", 1}});
  EXPECT_EQ(sent.size(), before);
  EXPECT_TRUE(finished.empty());
}

}  // namespace
}  // namespace gluray::control
