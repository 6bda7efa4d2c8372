// Comparison, saved images and the large window.
#include "pages/live/live_window.h"
#include "testing/live_view_fixture.h"

#include <QFile>
#include <QTemporaryDir>

namespace gluray::panel {
namespace {

using nlohmann::json;

struct LiveImagesTest : LiveViewFixture {};

TEST_F(LiveImagesTest, ComparesWithTheRealOpenGL) {
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
  EXPECT_NEAR(liveImage().divider(), 0.95, 0.01);
  EXPECT_EQ(pixel(150, 100), QColor(Qt::blue));
  EXPECT_TRUE(program.calls("pick").empty()) << "the divider was meant";
  QTest::keyClick(&liveImage(), Qt::Key_Left);
  EXPECT_NEAR(liveImage().divider(), 0.93, 0.01);
  button("compare-renew").click();
  EXPECT_EQ(batches().size(), 2u);
  button("tool-compare").click();
  EXPECT_EQ(pixel(20, 100), QColor(Qt::black));
}

TEST_F(LiveImagesTest, TheComparisonFollowsTheWindowsSize) {
  button("tool-compare").click();
  ASSERT_TRUE(program.until([&] { return program.calls("pixels").size() == 3; }));
  program.state();
  program.width = 60, program.height = 20;
  program.state();
  ASSERT_TRUE(program.until([&] { return program.calls("pixels").size() == 5; })) << "two pieces of ten rows";
}

TEST_F(LiveImagesTest, AComparisonThatFailsIsSaid) {
  program.refusals["shot"] = "no frame came";
  button("tool-compare").click();
  ASSERT_TRUE(program.until([&] { return !said.isEmpty(); }));
  EXPECT_EQ(said.back(), "No image of the real OpenGL: no frame came");
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

TEST_F(LiveImagesTest, SavesTheImageInFullSize) {
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

TEST_F(LiveImagesTest, PixelsThatDoNotFitAreRefused) {
  const QTemporaryDir folder;
  for (const json& piece :
       {json(), json(3), json{{"row", 1}, {"rows", 2}, {"pixels", ""}},
        json{{"row", 0}, {"rows", 31}, {"pixels", ""}}, json{{"row", 0}, {"rows", 1}, {"pixels", "AAAA"}},
        json{{"row", 0}, {"rows", 0}, {"pixels", ""}}, json{{"row", 0}, {"rows", 1}, {"pixels", 3}}}) {
    program.values["pixels"] = piece;
    view.saveTo(folder.filePath("a.png"));
    ASSERT_TRUE(program.until([&] { return said.back().startsWith("No image is saved"); })) << piece;
    said << "";
  }
  EXPECT_FALSE(QFile::exists(folder.filePath("a.png")));
}

TEST_F(LiveImagesTest, ALargeWindowShowsTheFullSizeOfWhatStandsStill) {
  program.controls.connected();
  LiveWindow window(program.controls, nullptr);
  window.show();
  EXPECT_EQ(program.sent.back()["type"], "observe");
  EXPECT_EQ(program.sent.back()["size"], 512);
  program.appear();
  program.width = 1200, program.height = 20;
  ASSERT_TRUE(program.until([&] { return !program.calls("pixels").empty(); })) << "nothing moves";
  LiveImage& large = window.view().liveImage();
  const auto aspect = [&] { return large.imageRect().width() / large.imageRect().height(); };
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
