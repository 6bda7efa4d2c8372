// An image is reused only if nothing visible has changed.
#include "frame/images/image_cache.h"

#include "accel/testing/test_scene.h"

#include <gtest/gtest.h>

#include <functional>

namespace gluray::frame {
namespace {

class ImageCacheTest : public testing::Test {
 protected:
  ImageCacheTest()
      : shown_(gluray::test::makeSnapshot({mesh_, gluray::test::makeMesh(gluray::test::squareData(0.5f))})) {
    keep(shown_);
  }
  uint64_t keep(const scene::Snapshot& snapshot) {
    const uint64_t id = images_.makeRoom().id;
    images_.keep(snapshot);
    return id;
  }
  /// Whether the image is found for the snapshot after `change`.
  bool foundAfter(const std::function<void(scene::Snapshot&)>& change) {
    scene::Snapshot changed = shown_;
    change(changed);
    return images_.findImage(changed) != nullptr;
  }

  scene::MeshPtr mesh_ = gluray::test::makeMesh(gluray::test::squareData());
  ImageCache images_;
  scene::Snapshot shown_;
};

TEST_F(ImageCacheTest, EqualSnapshotsAreFoundInAnyFrame) {
  EXPECT_TRUE(foundAfter([](scene::Snapshot&) {}));
  EXPECT_TRUE(foundAfter([](scene::Snapshot& s) { s.frame = 77; }));
}

TEST_F(ImageCacheTest, ChangedSnapshotsAreNotFound) {
  using S = scene::Snapshot;
  const std::vector<std::function<void(S&)>> changes = {
      [](S& s) { s.camera.clipFromEye[0][0] *= 2; },
      [](S& s) { s.camera.viewport.z = 17; },
      [](S& s) { s.camera.depthFar = 0.5f; },
      [](S& s) { s.camera.rowsFromTop = 3; },
      [](S& s) { s.camera.largestWins = true; },
      [](S& s) { s.eyeFromWorld[3][0] = 1e-9; },
      [](S& s) { s.region.width = 8; },
      [](S& s) { s.samples = 2; },
      [](S& s) { s.samplePositions = {glm::vec2(0.25f)}; },
      [](S& s) { s.polygonOffset.units = 1; },
      [](S& s) { s.laterWins = true; },
      [](S& s) { s.depthSteps = 65535; },
      [](S& s) { s.wideColors = true; },
      [](S& s) { s.layers = std::make_shared<scene::Layers>(); },
      [](S& s) { s.shadings[0].lighting = !s.shadings[0].lighting; },
      [](S& s) { s.shadings.emplace_back(); },
      [](S& s) { s.instances.pop_back(); },
      [](S& s) { std::swap(s.instances[0], s.instances[1]); },
      [](S& s) { s.instances[1].mesh = gluray::test::makeMesh(gluray::test::squareData(0.5f)); },
      [](S& s) { s.instances[0].color.r = 0.5f; },
      [](S& s) { s.instances[0].normal.x = 1; },
      [](S& s) { s.instances[0].materials[0].front.shininess = 3; },
      [](S& s) { s.instances[0].worldFromObject[3][1] = 1; },
      [](S& s) { s.instances[0].eyeFromObject[3][1] = 1; },
      [](S& s) { s.instances[0].clipPlanes.emplace_back(1, 0, 0, 0); },
      [](S& s) { s.instances[0].cull = scene::CullFace::back; },
      [](S& s) { s.instances[0].order = 9; },
      [](S& s) { s.instances[0].triangleColors.format = scene::Format::float4; },
      [](S& s) { s.instances[0].texcoordsAbove.emplace_back(1); },
      [](S& s) { s.instances[0].impostors.inside = true; },
      [](S& s) { s.settings.shading = ShadingRate::vertex; },
      [](S& s) { s.settings.spp = 4; },
  };
  for (size_t i = 0; i < changes.size(); ++i) EXPECT_FALSE(foundAfter(changes[i])) << "change " << i;
}

TEST_F(ImageCacheTest, SecondaryScenesAreComparedByContentAndNotKeptAlive) {
  using A = scene::SecondaryScene;
  auto instance = shown_.instances[0];
  instance.mesh = gluray::test::makeMesh(gluray::test::squareData(3));
  auto original = std::make_shared<A>();
  original->instances = {instance};
  original->shadings.resize(1);
  original->blended = {0};
  shown_.secondaryScene = original;
  keep(shown_);
  const auto foundWith = [&](const std::function<void(A&)>& change) {
    auto changed = std::make_shared<A>(*original);
    change(*changed);
    return foundAfter([&](scene::Snapshot& s) { s.secondaryScene = changed; });
  };
  EXPECT_TRUE(foundWith([](A&) {}));
  const std::vector<std::function<void(A&)>> changes = {
      [](A& a) { a.instances[0].worldFromObject[3][1] = 1; },
      [](A& a) { a.instances[0].mesh = gluray::test::makeMesh(gluray::test::squareData(4)); },
      [](A& a) { a.instances.push_back(a.instances[0]), a.blended.push_back(0); },
      [](A& a) { a.instances.clear(), a.blended.clear(); },
      [](A& a) { a.shadings[0].lighting = true; },
      [](A& a) { a.blended[0] = 1; },
      [](A& a) { a.viewFromWorld[3][0] = 1; },
  };
  for (size_t i = 0; i < changes.size(); ++i) EXPECT_FALSE(foundWith(changes[i])) << "change " << i;
  const std::weak_ptr<const scene::Mesh> mesh = instance.mesh;
  instance.mesh.reset(), original.reset(), shown_.secondaryScene.reset();
  EXPECT_TRUE(mesh.expired());
}

TEST_F(ImageCacheTest, LayersAreComparedByContent) {
  const auto layered = [&](float depth) {
    scene::Snapshot s = shown_;
    auto layers = std::make_shared<scene::Layers>();
    layers->opaqueDepth.assign(256, depth);
    s.layers = layers;
    return s;
  };
  keep(layered(0.5f));
  EXPECT_TRUE(images_.findImage(layered(0.5f)));
  EXPECT_FALSE(images_.findImage(layered(0.25f)));
}

TEST_F(ImageCacheTest, WrittenChannelsMatterWhereLayersAreBlendedInTheOrderOfDrawing) {
  for (const auto of : {scene::Layers::Of::order, scene::Layers::Of::sums, scene::Layers::Of::drawn}) {
    auto layers = std::make_shared<scene::Layers>();
    layers->of = of;
    shown_.layers = layers;
    keep(shown_);
    EXPECT_TRUE(foundAfter([](scene::Snapshot&) {}));
    EXPECT_EQ(foundAfter([](scene::Snapshot& s) { s.colorWrites.red = false; }),
              of != scene::Layers::Of::drawn);
  }
}

TEST_F(ImageCacheTest, SeveralAreKeptAndTheOldestIsReplaced) {
  std::vector<scene::Snapshot> others;
  for (int i = 0; i < 3; ++i) {
    others.push_back(shown_);
    others.back().camera.viewport.x = i + 1;
  }
  keep(others[0]), keep(others[1]);
  EXPECT_TRUE(images_.findImage(shown_));  // the most recently used
  keep(others[2]);
  EXPECT_TRUE(images_.findImage(shown_));
  EXPECT_FALSE(images_.findImage(others[0]));
  EXPECT_TRUE(images_.findImage(others[1]));
  EXPECT_TRUE(images_.findImage(others[2]));
}

TEST_F(ImageCacheTest, FindsTheImageWithTheRightMissColor) {
  for (const uint32_t color : {7u, 9u}) {
    images_.makeRoom().image.missColor = color;
    images_.keep(shown_);
  }
  const auto* seven = images_.findImage(shown_, 7);
  const auto* nine = images_.findImage(shown_, 9);
  ASSERT_TRUE(seven && nine);
  EXPECT_EQ(seven->image.missColor, 7u);
  EXPECT_EQ(nine->image.missColor, 9u);
  EXPECT_FALSE(images_.findImage(shown_, 8));
  EXPECT_TRUE(images_.findImage(shown_));
}

TEST_F(ImageCacheTest, OnlyTheLastLargeImageIsKept) {
  constexpr int kSide = 2560;  // 52 MB, more than half of the budget
  scene::Snapshot other = shown_;
  for (int i = 1; i < 6; ++i) {
    other.camera.viewport.x = i;
    ImageCache::CachedImage& cached = images_.makeRoom();
    cached.image.resize(kSide, kSide, 1);
    images_.keep(other);
    EXPECT_TRUE(images_.findImage(other));
  }
  EXPECT_LE(images_.bytes(), ImageCache::kBudget);
  other.camera.viewport.x = 4;
  EXPECT_FALSE(images_.findImage(other));
}

TEST_F(ImageCacheTest, MeshesAreNotKeptAlive) {
  const std::weak_ptr<const scene::Mesh> gone = mesh_;
  mesh_.reset();
  shown_ = {};
  EXPECT_TRUE(gone.expired());
}

TEST_F(ImageCacheTest, UnfinishedImagesAreNotFound) {
  scene::Snapshot other = shown_;
  other.camera.viewport.x = 5;
  images_.makeRoom();  // tracing fails
  EXPECT_FALSE(images_.findImage(other));
  EXPECT_FALSE(images_.findImage(scene::Snapshot{}));
}

TEST_F(ImageCacheTest, EveryImageHasAUniqueId) {
  const uint64_t first = keep(shown_), second = keep(shown_);
  EXPECT_NE(first, 0u);
  EXPECT_NE(first, second);
}

}  // namespace
}  // namespace gluray::frame
