#include "pages/live/live_view.h"

#include "model/save_picture.h"
#include "pages/live/live_window.h"
#include "testing/fake_program.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

namespace gluray::panel {
namespace {

using nlohmann::json;

struct LiveViewTest : testing::Test {
  void SetUp() override {
    QObject::connect(&view, &LiveView::said, &view, [this](const QString& line) { said << line; });
    QObject::connect(&view, &LiveView::picked, &view,
                     [this](int, uint32_t object) { picked.push_back(object); });
    program.appear();
    view.picture().setFixedSize(200, 150);
    view.show();
  }
  QToolButton& button(const char* name) { return *view.findChild<QToolButton*>(name); }
  LivePicture& picture() { return view.picture(); }
  QColor pixel(int x, int y) {
    const QImage image = picture().grab().toImage();
    return image.pixelColor((QPointF(x, y) * image.devicePixelRatio()).toPoint());
  }
  void press(int x, int y) { QTest::mousePress(&picture(), Qt::LeftButton, {}, {x, y}); }
  void move(int x, int y) { QTest::mouseMove(&picture(), {x, y}); }
  void release(int x, int y) { QTest::mouseRelease(&picture(), Qt::LeftButton, {}, {x, y}); }
  void click(int x, int y) { press(x, y), release(x, y); }

  FakeProgram program;
  LiveView view{program.controls, nullptr};
  QStringList said;
  std::vector<uint32_t> picked;
};

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

TEST_F(LiveViewTest, PlacesAreThoseOfThePictureAndNotOfTheWidget) {
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

TEST_F(LiveViewTest, LightStaysWhereNothingIsHit) {
  program.say("lights", "sun");
  button("tool-light").click();
  for (const json& value : {json{{"object", nullptr}, {"azimuth", nullptr}, {"elevation", nullptr}}, json(3),
                            json(), json{{"azimuth", "x"}, {"elevation", 4}}}) {
    program.values["highlight"] = value;
    click(30, 30);
    QTest::qWait(5);
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
  program.width = 400, program.height = 300;
  program.state();
  program.say("camera.aperture", 0.1);
  // The view is the right half of the window.
  program.values["pick"] = {{"object", 2}, {"view", 2}};
  program.values["cameras"] = {
      {"cameras",
       {{{"view", 1}, {"viewport", {0, 0, 200, 300}}}, {{"view", 2}, {"viewport", {200, 0, 200, 300}}}}}};
  button("tool-focus").click();
  click(150, 37);
  ASSERT_TRUE(program.until([&] { return !program.sets().empty(); }));
  const json values = program.sets()[0]["values"];
  EXPECT_EQ(values["camera.focus"], 0);
  EXPECT_NEAR(values["camera.focus-x"].get<double>(), 0.5, 0.01);
  EXPECT_NEAR(values["camera.focus-y"].get<double>(), 0.75, 0.01) << "upwards";
  EXPECT_EQ(said.back(), "Object 2 is in focus.");
}

TEST_F(LiveViewTest, FocusSurvivesWhatProgramsAnswer) {
  button("tool-focus").click();
  for (const json& cameras :
       {json(), json(4),
        json{{"cameras", {1, {{"view", 1}}, {{"view", 1}, {"viewport", {0, 0, "x", -1}}}}}}}) {
    program.values["pick"] = {{"object", 1}, {"view", 1}};
    program.values["cameras"] = cameras;
    const size_t before = program.sets().size();
    click(100, 75);
    ASSERT_TRUE(program.until([&] { return program.sets().size() > before; }));
    EXPECT_NEAR(program.sets().back()["values"]["camera.focus-x"].get<double>(), 0.5, 0.01);
  }
  EXPECT_TRUE(said.back().contains("nothing is blurred")) << "the lens is closed";
  program.values["pick"] = {{"object", nullptr}};
  const size_t before = program.sets().size();
  click(100, 75);
  ASSERT_TRUE(program.until([&] { return said.back().startsWith("Nothing"); }));
  EXPECT_EQ(program.sets().size(), before);
}

TEST_F(LiveViewTest, LightAndFocusExcludeEachOther) {
  button("tool-light").click();
  button("tool-focus").click();
  EXPECT_FALSE(button("tool-light").isChecked());
  EXPECT_TRUE(button("tool-focus").isChecked());
}

TEST_F(LiveViewTest, ComparesWithTheRealOpenGL) {
  program.say("engine", "always");
  program.thumbnail(40, 30, std::string(size_t{40 * 30 * 3}, '\0'));
  button("tool-compare").click();
  const auto batches = [&] {
    std::vector<json> found;
    for (const json& message : program.sent)
      if (message["type"] == "batch") found.push_back(message["requests"]);
    return found;
  };
  ASSERT_EQ(batches().size(), 1u);
  const json requests = batches()[0];
  ASSERT_EQ(requests.size(), 3u);
  EXPECT_EQ(requests[0]["values"], json({{"engine", "never"}}));
  EXPECT_EQ(requests[1]["name"], "shot");
  EXPECT_EQ(requests[2]["values"], json({{"engine", "always"}}));
  EXPECT_EQ(requests[0]["gesture"], requests[2]["gesture"]);
  ASSERT_TRUE(program.until([&] { return pixel(20, 100) == QColor(Qt::red); })) << "left: OpenGL";
  EXPECT_EQ(pixel(180, 100), QColor(Qt::black)) << "right: GLuRay";
  press(100, 75);
  move(190, 75), release(190, 75);
  EXPECT_NEAR(picture().divider(), 0.95, 0.01);
  EXPECT_EQ(pixel(150, 100), QColor(Qt::blue));
  EXPECT_TRUE(program.calls("pick").empty()) << "the divider was meant";
  QTest::keyClick(&picture(), Qt::Key_Left);
  EXPECT_NEAR(picture().divider(), 0.93, 0.01);
  button("compare-renew").click();
  EXPECT_EQ(batches().size(), 2u);
  button("tool-compare").click();
  EXPECT_EQ(pixel(20, 100), QColor(Qt::black));
}

TEST_F(LiveViewTest, TheComparisonFollowsTheWindowsSize) {
  button("tool-compare").click();
  ASSERT_TRUE(program.until([&] { return program.calls("pixels").size() == 3; }));
  const json first = program.sent.front();
  program.state();
  program.width = 60, program.height = 20;
  program.state();
  ASSERT_TRUE(program.until([&] { return program.calls("pixels").size() == 5; })) << "two pieces of ten rows";
}

TEST_F(LiveViewTest, AComparisonThatFailsIsSaid) {
  program.refusals["shot"] = "no frame came";
  button("tool-compare").click();
  ASSERT_TRUE(program.until([&] { return !said.isEmpty(); }));
  EXPECT_EQ(said.back(), "No picture of the real OpenGL: no frame came");
  EXPECT_EQ(program.sets().back()["values"], json({{"engine", nullptr}})) << "in the batch, too";
  EXPECT_EQ(pixel(180, 100), QColor(Qt::blue));
  program.refusals.clear();
  for (const json& shot : {json(), json{{"shot", 1}, {"width", 1e9}, {"height", 4}}, json{{"shot", "x"}}}) {
    program.values["shot"] = shot;
    said.clear();
    button("compare-renew").click();
    ASSERT_TRUE(program.until([&] { return !said.isEmpty(); }));
  }
}

TEST_F(LiveViewTest, SavesThePictureInFullSize) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("a.png");
  view.saveTo(file);
  ASSERT_TRUE(program.until([&] { return said.back() == file + ", 40 x 30"; }));
  const QImage saved(file);
  EXPECT_EQ(saved.size(), QSize(40, 30));
  EXPECT_EQ(saved.pixelColor(5, 29), QColor(Qt::red));
  EXPECT_EQ(saved.pixelColor(35, 0), QColor(Qt::blue));
  view.saveTo(folder.filePath("missing/a.png"));
  ASSERT_TRUE(program.until([&] { return said.back().contains("missing"); }));
}

TEST_F(LiveViewTest, PixelsThatDoNotFitAreRefused) {
  const QTemporaryDir folder;
  for (const json& piece :
       {json(), json(3), json{{"row", 1}, {"rows", 2}, {"pixels", ""}},
        json{{"row", 0}, {"rows", 31}, {"pixels", ""}}, json{{"row", 0}, {"rows", 1}, {"pixels", "AAAA"}},
        json{{"row", 0}, {"rows", 0}, {"pixels", ""}}, json{{"row", 0}, {"rows", 1}, {"pixels", 3}}}) {
    program.values["pixels"] = piece;
    view.saveTo(folder.filePath("a.png"));
    ASSERT_TRUE(program.until([&] { return said.back().startsWith("No picture is saved"); })) << piece;
    said << "";
  }
  EXPECT_FALSE(QFile::exists(folder.filePath("a.png")));
}

TEST_F(LiveViewTest, ALargeWindowShowsTheFullSizeOfWhatStandsStill) {
  program.controls.connected();
  LiveWindow window(program.controls, nullptr);
  window.show();
  EXPECT_EQ(program.sent.back()["type"], "observe");
  EXPECT_EQ(program.sent.back()["size"], 512);
  program.appear();
  program.width = 1200, program.height = 20;
  ASSERT_TRUE(program.until([&] { return !program.calls("pixels").empty(); })) << "nothing moves";
  LivePicture& large = window.view().picture();
  const auto aspect = [&] { return large.pictureRect().width() / large.pictureRect().height(); };
  ASSERT_TRUE(program.until([&] { return aspect() > 10; }));
  program.thumbnail(40, 30);  // the same again
  EXPECT_GT(aspect(), 10);
  program.thumbnail(40, 30, std::string(size_t{40 * 30 * 3}, '\0'));
  EXPECT_LT(aspect(), 10) << "the thumbnail is newer";
  window.hide();
  EXPECT_FALSE(program.sent.back().contains("size"));
}

}  // namespace
}  // namespace gluray::panel
