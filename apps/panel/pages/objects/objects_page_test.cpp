// The page of objects: which ones it shows, how it asks for them, and what is selected.
#include "testing/objects_page_fixture.h"

#include <QElapsedTimer>
#include <QTest>

namespace gluray::panel {
namespace {

using nlohmann::json;

TEST_F(ObjectsPageTest, ShowsWhatTheProgramDraws) {
  program.values["objects"]["objects"][1] = fakeObject(2, nullptr, "glass");
  program.values["objects"]["objects"][1]["hidden"] = {"camera", "shadow"};
  showThem();
  EXPECT_EQ(rows(), 4);
  EXPECT_EQ(cell(0, 0), "1");
  EXPECT_EQ(cell(0, 1), "#cc4400");
  EXPECT_EQ(cell(1, 1), "varies");
  EXPECT_EQ(cell(1, 3), "2 000");
  EXPECT_EQ(cell(1, 4), "glass");
  EXPECT_EQ(cell(1, 5), "camera, shadow");
  EXPECT_EQ(message(), "4 objects.");
}

TEST_F(ObjectsPageTest, AsksWithTheVersionItKnowsWhileItIsSeen) {
  program.appear();
  program.settle();
  EXPECT_TRUE(program.calls("objects").empty()) << "nobody looks";
  showThem();
  EXPECT_EQ(program.calls("objects")[0]["arguments"], json({{"after", 0}, {"count", 1000}}));
  program.values["objects"] = {{"frame", 6}, {"version", 1}, {"total", 4}, {"same", true}};
  poll();
  EXPECT_EQ(program.calls("objects").back()["arguments"]["known"], 1);
  EXPECT_EQ(rows(), 4);
  const size_t before = program.calls("objects").size();
  ASSERT_TRUE(program.until([&] { return program.calls("objects").size() > before; })) << "every second";
  page.hide();
  const size_t hidden = program.calls("objects").size();
  QTest::qWait(1200);
  EXPECT_EQ(program.calls("objects").size(), hidden);
}

TEST_F(ObjectsPageTest, LongListsComeInPieces) {
  program.answers = false;
  program.appear();
  page.show();
  const json all = fakeObjects(2500)["objects"];
  for (const int from : {0, 1000, 2000}) {
    const json request = program.calls("objects").back();
    EXPECT_EQ(request["arguments"]["after"], from);
    json piece = json::array();
    for (size_t i = static_cast<size_t>(from); i < all.size() && piece.size() < 1000; ++i)
      piece.push_back(all[i]);
    program.answerValue(request, {{"version", 1}, {"total", 2500}, {"objects", piece}});
  }
  EXPECT_EQ(rows(), 2500);
  EXPECT_EQ(program.calls("objects").size(), 3u);
}

TEST_F(ObjectsPageTest, TheSelectionStaysWhenObjectsComeAndGo) {
  showThem();
  page.select(3);
  EXPECT_EQ(selected(), std::vector<std::string>{"3"});
  program.values["objects"] = fakeObjects(9, 2);
  program.values["objects"]["objects"].erase(0);
  poll();
  EXPECT_EQ(rows(), 8);
  EXPECT_EQ(selected(), std::vector<std::string>{"3"});
  EXPECT_EQ(title(), "Object 3");
  page.select(0);
  EXPECT_TRUE(selected().empty());
  EXPECT_EQ(title(), "No object is selected.");
}

TEST_F(ObjectsPageTest, AnObjectThatIsNotYetKnownIsSelectedWhenItComes) {
  showThem();
  page.select(7);
  EXPECT_TRUE(selected().empty());
  program.values["objects"] = fakeObjects(8, 2);
  poll();
  EXPECT_EQ(selected(), std::vector<std::string>{"7"});
}

TEST_F(ObjectsPageTest, SortsByNumbersAndFilters) {
  program.values["objects"] = fakeObjects(12);
  showThem();
  table().sortByColumn(3, Qt::DescendingOrder);
  EXPECT_EQ(cell(0, 0), "12");
  EXPECT_EQ(cell(11, 0), "1");
  page.select(6);
  EXPECT_EQ(page.filter("SPHERES cc44"), 4);
  EXPECT_EQ(selected(), std::vector<std::string>{"6"});
  EXPECT_EQ(page.filter("nothing"), 0);
  EXPECT_EQ(title(), "No object is selected.") << "what is not seen is not changed";
  EXPECT_EQ(page.filter(""), 12);
}

TEST_F(ObjectsPageTest, ShowsWhyThereAreNone) {
  program.refusals["objects"] = "no call is named objects";
  program.appear();
  page.show();
  ASSERT_TRUE(program.until([&] { return message() == "No objects: no call is named objects"; }));
  EXPECT_FALSE(table().isVisible());
  program.refusals.clear();
  ASSERT_TRUE(program.until([&] { return rows() == 4; })) << "it is asked again";
  EXPECT_TRUE(table().isVisible());
  program.end();
  EXPECT_EQ(rows(), 0);
  EXPECT_EQ(message(), "No program is chosen.");
}

TEST_F(ObjectsPageTest, KeepsWhatIsThereWhileTheProgramFailsForAMoment) {
  showThem();
  program.refusals["objects"] = "nothing is traced";
  poll();
  EXPECT_EQ(rows(), 4);
  EXPECT_EQ(message(), "4 objects.");
  program.refusals.clear();
  poll();
  program.refusals["objects"] = "nothing is traced";
  QElapsedTimer time;
  time.start();
  ASSERT_TRUE(QTest::qWaitFor([&] { return message() == "No objects: nothing is traced"; }, 20000));
  EXPECT_GE(time.elapsed(), 3000) << "since the last failure";
  EXPECT_EQ(rows(), 0);
}

TEST_F(ObjectsPageTest, SurvivesAnswersThatAreNoneOfTheProtocol) {
  program.answers = false;
  program.appear();
  page.show();
  const json good = fakeObject(1);
  json odd = good;
  odd.update({{"object", 2}, {"color", 5}, {"shape", nullptr}, {"triangles", "many"}, {"hidden", {1, "x"}}});
  for (const json& value :
       {json(), json(3), json::array(), json{{"objects", 3}}, json{{"objects", {1, nullptr, json::object()}}},
        json{{"objects", {{{"object", -4}}}}}, json{{"objects", {good, good}}, {"total", -1}},
        json{{"same", 1}}, json{{"objects", json::array()}, {"total", 1e300}},
        json{{"objects", {odd}}, {"version", json::object()}, {"total", 1}}}) {
    program.answerValue(program.calls("objects").back(), value);
    page.hide(), page.show();
  }
  program.say("material.objects", {1, "x", "1 hidden-from=nonsense glass=2 ior=?", nullptr});
  program.say("material.objects", 5);
  page.select(2);
  EXPECT_EQ(cell(0, 1), "varies");
}

}  // namespace
}  // namespace gluray::panel
