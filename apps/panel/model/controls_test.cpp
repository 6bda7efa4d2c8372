#include "model/controls.h"

#include <gtest/gtest.h>

namespace gluray::panel {
namespace {

using nlohmann::json;

struct ControlsTest : testing::Test {
  void SetUp() override {
    QObject::connect(&controls, &Controls::said, &controls,
                     [this](const QString& line) { said.push_back(line.toStdString()); });
    QObject::connect(&controls, &Controls::settingsChanged, &controls, [this] { ++settings; });
  }
  void take(const json& message) { controls.receiveMessage(std::make_shared<const json>(message)); }
  void takePrograms(std::initializer_list<int> numbers) {
    json list = json::array();
    for (const int n : numbers)
      list.push_back({{"program", n},
                      {"pid", 100 + n},
                      {"host", "here"},
                      {"name", "p" + std::to_string(n)},
                      {"ranks", 1}});
    take({{"type", "event"}, {"what", "programs"}, {"programs", list}});
  }
  void takeValue(int program, const char* name, const json& value) {
    take({{"type", "event"},
          {"what", "settings"},
          {"program", program},
          {"values", {{name, {{"value", value}, {"layer", "live"}, {"place", ""}}}}},
          {"undo", 1},
          {"redo", 0}});
  }

  std::vector<json> sent;
  Controls controls{[this](json message) { sent.push_back(std::move(message)); }};
  std::vector<std::string> said;
  int settings = 0;
};

TEST_F(ControlsTest, AsksForEverythingWhenConnected) {
  controls.connected();
  ASSERT_EQ(sent.size(), 2u);
  EXPECT_EQ(sent[0]["type"], "observe");
  EXPECT_EQ(sent[1]["type"], "list");
  take({{"type", "answer"}, {"id", sent[1]["id"]}, {"programs", {{{"program", 1}, {"name", "p"}}}}});
  ASSERT_NE(controls.shown(), nullptr);
  EXPECT_EQ(controls.shown()->name, "p");
}

TEST_F(ControlsTest, ThumbnailsAreChecked) {
  takePrograms({1});
  const auto thumbnail = [&](const json& width, const json& height, const json& pixels) {
    take({{"type", "event"},
          {"what", "thumbnail"},
          {"program", 1},
          {"width", width},
          {"height", height},
          {"pixels", pixels}});
    return controls.shown()->thumbnail.size();
  };
  for (const json& pixels : {json("AAAA"), json("AAAAAAAAAAA="), json("?"), json(), json(3)})
    EXPECT_TRUE(thumbnail(2, 1, pixels).isEmpty()) << pixels;
  EXPECT_TRUE(thumbnail(-1, -1, "AAAA").isEmpty());
  EXPECT_TRUE(thumbnail(1 << 20, 1 << 20, "AAAA").isEmpty());
  EXPECT_TRUE(thumbnail("1", 1, "AAAA").isEmpty());
  EXPECT_EQ(thumbnail(2, 1, "/wAAAAD/"), QSize(2, 1));
  EXPECT_EQ(controls.shown()->thumbnail.pixelColor(1, 0), QColor(Qt::blue));
  EXPECT_EQ(thumbnail(2, 1, "AAAA"), QSize(2, 1)) << "the last one stays";
}

TEST_F(ControlsTest, ValuesAreBuiltInUntilAProgramSaysMore) {
  EXPECT_EQ(controls.value("ao").value, false);
  takePrograms({1});
  takeValue(1, "ao", true);
  EXPECT_EQ(controls.value("ao").value, true);
  EXPECT_EQ(controls.value("ao").layer, "live");
  EXPECT_EQ(controls.shown()->undo, 1);
}

TEST_F(ControlsTest, ChangesGoToTheChosenProgramOrAll) {
  takePrograms({1, 2});
  controls.set("ao", true);
  controls.undo();
  EXPECT_TRUE(sent.empty());  // nothing is chosen
  controls.chooseAll();
  controls.set("ao", true);
  EXPECT_EQ(sent.back()["program"], "all");
  controls.choose(2);
  controls.set("ao.samples", 4, "drag");
  EXPECT_EQ(sent.back()["program"], 2);
  EXPECT_EQ(sent.back()["values"], json({{"ao.samples", 4}}));
  EXPECT_EQ(sent.back()["gesture"], "drag");
  controls.undo();
  EXPECT_EQ(sent.back()["type"], "undo");
}

TEST_F(ControlsTest, ProgramsMayDiffer) {
  takePrograms({1, 2});
  controls.chooseAll();
  EXPECT_FALSE(controls.differs("ao"));
  takeValue(2, "ao", true);
  EXPECT_TRUE(controls.differs("ao"));
  controls.choose(1);
  EXPECT_FALSE(controls.differs("ao"));
}

TEST_F(ControlsTest, RefusalsAreSaidAndTheOldValuesShownAgain) {
  takePrograms({1});
  controls.set("ao.samples", 0);
  settings = 0;
  take({{"type", "answer"},
        {"id", sent.back()["id"]},
        {"results", {{{"program", 1}, {"why", "ao.samples=0: use a number"}}}}});
  EXPECT_EQ(said.back(), "ao.samples=0: use a number");
  EXPECT_EQ(settings, 1);
}

TEST_F(ControlsTest, ProgramsThatEndAreForgottenAndOthersKeepTheirValues) {
  takePrograms({1, 2});
  takeValue(2, "ao", true);
  controls.choose(1);
  takePrograms({2});
  EXPECT_FALSE(controls.chosen());
  EXPECT_FALSE(controls.all());  // what was meant for one program is not for another
  EXPECT_EQ(controls.shown(), nullptr);
  controls.choose(2);
  EXPECT_EQ(controls.value("ao").value, true);
  controls.disconnected("the other side closed it");
  EXPECT_EQ(controls.shown(), nullptr);
  EXPECT_EQ(said.back(), "the other side closed it");
}

TEST_F(ControlsTest, SettingsMayComeBeforeTheList) {
  takeValue(7, "ao", true);
  takePrograms({7});
  EXPECT_EQ(controls.programs().size(), 1u);
  EXPECT_EQ(controls.value("ao").value, true);
  EXPECT_EQ(controls.shown()->undo, 1);
  EXPECT_EQ(controls.shown()->name, "p7");
}

TEST_F(ControlsTest, AProgramThatComesAloneIsChosenAndStaysSo) {
  takePrograms({3});
  EXPECT_EQ(controls.chosen(), 3);
  takePrograms({3, 4});
  EXPECT_EQ(controls.chosen(), 3);
  controls.set("ao", true);
  EXPECT_EQ(sent.back()["program"], 3);
}

TEST_F(ControlsTest, TheChosenProgramIsKnownAgainAtAnotherHub) {
  const auto list = [&](int first, int second) {
    take({{"type", "event"},
          {"what", "programs"},
          {"programs",
           {{{"program", first}, {"pid", 50}, {"host", "here"}, {"name", "a"}},
            {{"program", second}, {"pid", 60}, {"host", "here"}, {"name", "b"}}}}});
  };
  list(1, 2);
  controls.choose(2);
  controls.disconnected("it ended");
  EXPECT_EQ(controls.shown(), nullptr);
  list(8, 7);
  EXPECT_EQ(controls.chosen(), 7);
}

TEST_F(ControlsTest, FailuresOfSeveralNameTheProgram) {
  takePrograms({1, 2});
  controls.chooseAll();
  takeValue(2, "ao", true);
  EXPECT_EQ(controls.undoSteps(), 1);
  controls.undo();
  take(
      {{"type", "answer"},
       {"id", sent.back()["id"]},
       {"results", {{{"program", 1}, {"why", "there is nothing to undo"}}, {{"program", 2}, {"frame", 3}}}}});
  EXPECT_EQ(said.back(), "p1 (101): there is nothing to undo");
}

TEST_F(ControlsTest, SurvivesMessagesThatAreNoneOfTheProtocol) {
  takePrograms({1});
  for (const json& message :
       {json::object(), json{{"type", 3}}, json{{"type", "event"}},
        json{{"type", "event"}, {"what", "settings"}, {"program", "x"}},
        json{{"type", "event"}, {"what", "settings"}, {"program", 1}, {"values", 7}},
        json{{"type", "event"}, {"what", "settings"}, {"program", 1}, {"values", {{"ao", 1}}}},
        json{{"type", "event"}, {"what", "programs"}, {"programs", {1, "a", json::object()}}},
        json{{"type", "event"}, {"what", "programs"}, {"programs", 5}},
        json{{"type", "event"},
             {"what", "state"},
             {"program", 1},
             {"state", {{"fps", "fast"}, {"traced", "x"}}}},
        json{{"type", "answer"}, {"id", -1}}, json{{"type", "answer"}, {"id", 1.5}, {"results", 3}},
        json{{"type", "error"}, {"why", 5}}})
    take(message);
}

}  // namespace
}  // namespace gluray::panel
