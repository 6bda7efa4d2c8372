// Scenes are read as they were saved.
#include "saved/scene/saved_scene.h"

#include "base/testing/temporary_folder.h"
#include "saved/testing/saved_pictures.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

namespace gluray::saved {
namespace {

using frame::test::averaged, frame::test::balls;
using namespace test;

TEST(SavedScene, IsReadAsItWasWritten) {
  const gluray::test::TemporaryFolder folder;
  const std::string path = folder.file("scene.gluray");
  scene::Snapshot s = averaged(balls(kSide), 4);
  s.settings.ao.radius = 0.123456789f, s.settings.lights.file = "lights of mine.toml";
  SavedScene scene = sceneOf(s);
  scene.batches.front().place = {3, 4}, scene.batches.front().strict = false;
  scene.batches.front().cleared = {{1, 2, 3, 4}};
  scene.facts = {{"program", "a \xff program"}};
  scene.shown = {1, 2, {5, 6}};
  ASSERT_EQ(saveScene(scene, path), "");
  const SavedScene read = readScene(path);
  EXPECT_EQ(read.window, scene.window);
  EXPECT_EQ(read.shown.pixels, scene.shown.pixels);
  ASSERT_EQ(read.batches.size(), 1u);
  const SavedBatch& batch = read.batches.front();
  EXPECT_EQ(batch.place, glm::ivec2(3, 4));
  EXPECT_FALSE(batch.strict);
  EXPECT_EQ(batch.cleared, scene.batches.front().cleared);
  EXPECT_EQ(batch.snapshot->settings.ao.radius, s.settings.ao.radius);
  EXPECT_EQ(batch.snapshot->settings.lights.file, s.settings.lights.file);
  ASSERT_EQ(batch.snapshot->instances.size(), s.instances.size());
  frame::test::CountingTrace tracer;
  EXPECT_EQ(tracer.image(*batch.snapshot).color, tracer.image(s).color);
  // To the byte: what is read is written again equally.
  const std::string again = folder.file("again.gluray");
  ASSERT_EQ(saveScene(read, again), "");
  EXPECT_TRUE(gluray::test::textOf(folder.file("scene.gluray")) ==
              gluray::test::textOf(folder.file("again.gluray")));
}

TEST(SavedScene, SaysWhatIsWrong) {
  const gluray::test::TemporaryFolder folder;
  const SavedScene scene = sceneOf(balls(kSide));
  EXPECT_NE(saveScene(scene, folder.file("no/scene.gluray")).find("cannot be written"), std::string::npos);
  EXPECT_THROW(readScene(folder.file("missing.gluray")), std::runtime_error);
  SavedScene volumes = scene;
  auto s = std::make_shared<scene::Snapshot>(*scene.batches.front().snapshot);
  s->volumes.emplace_back();
  volumes.batches.push_back({s});
  EXPECT_NE(saveScene(volumes, folder.file("scene.gluray")).find("volumes"), std::string::npos);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace gluray::saved
