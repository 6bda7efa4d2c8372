#include "testing/live_view_fixture.h"

namespace gluray::panel {
namespace {

using nlohmann::json;

struct LiveViewTest : LiveViewFixture {};

TEST_F(LiveViewTest, AClickAsksWhatIsThere) {
  program.values["pick"] = {
      {"frame", 3}, {"object", 4}, {"view", 1}, {"position", {0.5, -2, 1e-3}}, {"distance", 12.34567}};
  click(50, 30);
  ASSERT_EQ(program.calls("pick").size(), 1u);
  EXPECT_EQ(program.calls("pick")[0]["arguments"],
            json({{"x", 50}, {"y", 30}, {"width", 200}, {"height", 150}}));
  ASSERT_TRUE(program.until([&] { return !picked.empty(); }));
  EXPECT_EQ(picked, std::vector<uint32_t>{4});
  EXPECT_EQ(said.back(), "Object 4 at 0.5, -2, 0.001, distance 12.35");
}

TEST_F(LiveViewTest, PlacesAreThoseOfTheImageAndNotOfTheWidget) {
  program.thumbnail(40, 10);  // 200 x 50 in the middle
  click(100, 20);
  EXPECT_TRUE(program.calls("pick").empty()) << "above it";
  click(199, 99);
  ASSERT_EQ(program.calls("pick").size(), 1u);
  EXPECT_EQ(program.calls("pick")[0]["arguments"],
            json({{"x", 199}, {"y", 49}, {"width", 200}, {"height", 50}}));
}

TEST_F(LiveViewTest, NothingThereIsSaidToo) {
  program.values["pick"] = {{"object", nullptr}};
  click(5, 5);
  ASSERT_TRUE(program.until([&] { return !picked.empty(); }));
  EXPECT_EQ(picked, std::vector<uint32_t>{0});
  program.refusals["pick"] = "the view is not known";
  click(5, 5);
  ASSERT_TRUE(program.until([&] { return said.back() == "the view is not known"; }));
  EXPECT_EQ(picked.size(), 1u);
}

TEST_F(LiveViewTest, PickingSurvivesWhatProgramsAnswer) {
  for (const json& value : {json{{"object", "x"}}, json{{"object", -1}, {"position", {1, 2}}},
                            json{{"object", 1e300}, {"distance", "far"}}, json::object()}) {
    program.values["pick"] = value;
    picked.clear();
    click(5, 5);
    ASSERT_TRUE(program.until([&] { return !picked.empty(); }));
    EXPECT_EQ(picked, std::vector<uint32_t>{0});
  }
  program.values["pick"] = {{"object", 2}, {"position", {1, nullptr, 2}}, {"distance", json::array()}};
  click(5, 5);
  ASSERT_TRUE(program.until([&] { return said.back() == "Object 2"; }));
  picked.clear();
  for (const json& value : {json(3), json(), json::array()}) {
    program.values["pick"] = value;
    said << "";
    click(5, 5);
    ASSERT_TRUE(program.until([&] { return !said.back().isEmpty(); }));
  }
  EXPECT_TRUE(picked.empty());
}

TEST_F(LiveViewTest, LightFollowsTheNewestPlaceOneCallAtATime) {
  program.say("lights", "program");
  program.answers = false;
  button("tool-light").click();
  press(10, 10);
  for (int i = 0; i < 30; ++i) move(20 + i, 20);
  ASSERT_EQ(program.calls("highlight").size(), 1u);
  EXPECT_EQ(said.back(), "lights = headlight+key in place of the program's lights");
  const auto answer = [&](double azimuth) {
    program.answerValue(program.calls("highlight").back(),
                        {{"object", 1}, {"azimuth", azimuth}, {"elevation", 20.04}});
  };
  answer(10);
  ASSERT_EQ(program.calls("highlight").size(), 2u);
  EXPECT_EQ(program.calls("highlight")[1]["arguments"]["x"], 49) << "those between are left out";
  release(90, 20);
  answer(11);
  ASSERT_EQ(program.calls("highlight").size(), 3u);
  EXPECT_EQ(program.calls("highlight")[2]["arguments"]["x"], 90);
  answer(12.06);
  EXPECT_EQ(program.calls("highlight").size(), 3u);
  const auto sets = program.sets();
  ASSERT_GE(sets.size(), 2u);
  EXPECT_EQ(sets.back()["values"],
            json({{"lights", "headlight+key"}, {"lights.azimuth", 12.1}, {"lights.elevation", 20.0}}));
  for (const json& set : sets) EXPECT_EQ(set["gesture"], sets[0]["gesture"]);
  EXPECT_TRUE(program.calls("pick").empty());
  click(30, 30);
  answer(40);
  EXPECT_EQ(program.sets().size(), sets.size() + 1) << "a click is a movement, too";
}

TEST_F(LiveViewTest, TheSkyGetsAKeyLight) {
  program.values["highlight"] = {{"object", 1}, {"azimuth", 10}, {"elevation", 20}};
  program.say("lights", "sky");
  button("tool-light").click();
  click(30, 30);
  ASSERT_TRUE(program.until([&] { return !program.sets().empty(); }));
  EXPECT_EQ(program.sets()[0]["values"]["lights"], "headlight+key");
  EXPECT_EQ(said.back(), "lights = headlight+key in place of sky, which has no key light");
}

TEST_F(LiveViewTest, LightStaysWhereNothingIsHit) {
  program.say("lights", "sun");
  button("tool-light").click();
  for (const json& value : {json{{"object", nullptr}, {"azimuth", nullptr}, {"elevation", nullptr}}, json(3),
                            json(), json{{"azimuth", "x"}, {"elevation", 4}}}) {
    program.values["highlight"] = value;
    click(30, 30);
    program.settle();
  }
  EXPECT_EQ(program.calls("highlight").size(), 8u) << "pressed and released";
  EXPECT_TRUE(program.sets().empty());
  program.values["highlight"] = {{"azimuth", 1e9}, {"elevation", -1e9}};
  click(30, 30);
  ASSERT_TRUE(program.until([&] { return !program.sets().empty(); }));
  EXPECT_EQ(program.sets()[0]["values"], json({{"lights.azimuth", 360.0}, {"lights.elevation", -90.0}}));
}

TEST_F(LiveViewTest, ADragEndsWithItsProgram) {
  program.answers = false;
  button("tool-light").click();
  press(10, 10);
  const json late = program.calls("highlight").back();
  program.end();
  move(20, 20), release(20, 20);
  program.answerValue(late, {{"azimuth", 3}, {"elevation", 4}});
  EXPECT_TRUE(program.sets().empty());
  EXPECT_EQ(program.calls("highlight").size(), 1u);
}

TEST_F(LiveViewTest, FocusIsSharesOfItsView) {
  program.say("camera.aperture", 0.1);
  program.values["pick"] = {{"object", 2}, {"view", 2}, {"share", {0.5, 0.7504}}};
  button("tool-focus").click();
  click(150, 37);
  ASSERT_TRUE(program.until([&] { return !program.sets().empty(); }));
  EXPECT_EQ(program.sets()[0]["values"],
            json({{"camera.focus", 0}, {"camera.focus-x", 0.5}, {"camera.focus-y", 0.75}}));
  EXPECT_EQ(said.back(), "Object 2 is in focus.");
  EXPECT_EQ(program.calls("pick").size(), 1u);
  EXPECT_TRUE(program.calls("cameras").empty());
}

TEST_F(LiveViewTest, FocusStaysWhereNothingCanBeRead) {
  button("tool-focus").click();
  for (const json& value : {json(), json(4), json{{"object", 1}}, json{{"object", 1}, {"share", nullptr}},
                            json{{"object", 1}, {"share", {1}}}, json{{"object", 1}, {"share", {1, "x"}}},
                            json{{"object", "x"}, {"share", {0, 0}}}}) {
    program.values["pick"] = value;
    said.clear();
    click(100, 75);
    ASSERT_TRUE(program.until([&] { return !said.empty(); }));
    EXPECT_EQ(said.back(), "the program's answer cannot be read") << value.dump();
  }
  program.values["pick"] = {{"object", nullptr}, {"share", nullptr}};
  click(100, 75);
  ASSERT_TRUE(program.until([&] { return said.back().startsWith("There is no"); }));
  program.refusals["pick"] = "the view is shown at a place that is not known";
  click(100, 75);
  ASSERT_TRUE(program.until([&] { return said.back().startsWith("the view is shown"); }));
  EXPECT_TRUE(program.sets().empty());
  program.refusals.clear();
  program.values["pick"] = {{"object", 1}, {"share", {-0.1, 7}}};
  click(100, 75);
  ASSERT_TRUE(program.until([&] { return !program.sets().empty(); }));
  EXPECT_EQ(program.sets()[0]["values"],
            json({{"camera.focus", 0}, {"camera.focus-x", 0.0}, {"camera.focus-y", 1.0}}));
  EXPECT_TRUE(said.back().contains("nothing is blurred")) << "the lens is closed";
}

TEST_F(LiveViewTest, LightAndFocusExcludeEachOther) {
  button("tool-light").click();
  button("tool-focus").click();
  EXPECT_FALSE(button("tool-light").isChecked());
  EXPECT_TRUE(button("tool-focus").isChecked());
}

}  // namespace
}  // namespace gluray::panel
