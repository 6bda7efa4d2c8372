// Options of gluray run --shot, and the folder through which scenes come.
#include "capture/shot_options.h"

#include "base/testing/temporary_folder.h"
#include "capture/scene_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace gluray::launcher {
namespace {

TEST(ShotOptions, SayWhen) {
  EXPECT_EQ(planOf("idle"), "idle");
  EXPECT_EQ(planOf("12"), "frame:12");
  EXPECT_EQ(planOf("2.5s"), "seconds:2.5");
  EXPECT_EQ(planOf("every"), "every:1");
  EXPECT_EQ(planOf("every:10"), "every:10");
  for (const char* wrong : {"", "0", "-3", "s", "xs", "-1s", "every:0", "every:x", "soon", "12 "})
    EXPECT_THROW(planOf(wrong), std::runtime_error) << wrong;
}

TEST(ShotOptions, NumberSequences) {
  EXPECT_EQ(fileOfShot({.file = "a.png"}, 7), "a.png");
  EXPECT_EQ(fileOfShot({.file = "step-%03d.png", .when = "every"}, 7), "step-007.png");
  EXPECT_EQ(fileOfShot({.file = "d/step-%d.gluray", .when = "every:2"}, 7), "d/step-7.gluray");
  EXPECT_EQ(fileOfShot({.file = "step.glb", .when = "every"}, 7), "step-0007.glb");
}

TEST(ShotOptions, AreChecked) {
  EXPECT_EQ(problemOf({}), "");
  EXPECT_EQ(problemOf({.file = "a.png", .when = "3", .quit = true, .settings = {"spp=4"}}), "");
  EXPECT_EQ(problemOf({.file = "a-%02d.ply", .when = "every"}), "");
  EXPECT_EQ(problemOf({.file = "a-%02d.exr", .when = "every"}), "");
  for (const ShotOptions& wrong :
       {ShotOptions{.when = "3"}, ShotOptions{.quit = true}, ShotOptions{.settings = {"spp=4"}},
        ShotOptions{.file = "a.jpg"}, ShotOptions{.file = "a"}, ShotOptions{.file = ".png"},
        ShotOptions{.file = "a.png", .when = "soon"}, ShotOptions{.file = "a.png", .settings = {"spp"}},
        ShotOptions{.file = "a-%s.png", .when = "every"},
        ShotOptions{.file = "a.png", .when = "every", .quit = true}}) {
    const std::string problem = problemOf(wrong);
    EXPECT_NE(problem, "") << wrong.file << wrong.when;
    EXPECT_EQ(problem.find('\n'), problem.npos);
  }
}

void writeText(const std::string& file, const std::string& text) { std::ofstream(file) << text; }

TEST(SceneFolder, GivesFramesInTheirOrder) {
  const test::TemporaryFolder place;
  std::string path;
  {
    const SceneFolder folder(place.file("picture.png"));
    path = folder.path();
    EXPECT_FALSE(folder.next());
    EXPECT_FALSE(folder.frames());
    writeText(path + "/000000000012.why", "volumes cannot be saved");
    writeText(path + "/000000000010.gluray", "scene");
    writeText(path + "/.draft", "half");
    auto frame = folder.next();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->frame, 10u);
    EXPECT_EQ(frame->scene, path + "/000000000010.gluray");
    folder.remove(*frame);
    frame = folder.next();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->why, "volumes cannot be saved");
    EXPECT_EQ(frame->scene, "");
    folder.remove(*frame);
    EXPECT_FALSE(folder.next());
    writeText(path + "/frames", "12");
    EXPECT_EQ(folder.frames(), 12u);
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(SceneFolder, NeedsAPlace) {
  EXPECT_THROW(SceneFolder folder("/nowhere/at/all/picture.png"), std::runtime_error);
}

}  // namespace
}  // namespace gluray::launcher
