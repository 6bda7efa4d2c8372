// The program's answers to requests that change its settings: set, undo, redo, and held changes.
#include "control/testing/program_side_fixture.h"

namespace gluray::control::test {
namespace {

TEST_F(ProgramSideTest, SetIsAnsweredWhenAFrameHasTheValues) {
  EXPECT_EQ(ask(setting({{"ao", true}, {"ao.samples", 32}})), json());
  source.endFrame(), source.takeNewer(version);
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
  begin(), receiveMessage(hold);
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
  for (int i = 0; i < 100; ++i) hold["values"]["spp"] = 2, hold["id"] = i, receiveMessage(hold);
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

}  // namespace
}  // namespace gluray::control::test
