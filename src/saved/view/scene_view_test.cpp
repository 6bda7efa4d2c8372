// Scenes that somebody looks at: finished pictures are those of Shot, and views that change are left at once.
#include "saved/view/scene_view.h"

#include "saved/shot/picture_settings.h"
#include "saved/testing/saved_pictures.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gluray::saved {
namespace {

using frame::test::averaged, frame::test::balls, frame::test::Floor, frame::test::layered;
using namespace test;

using Values = std::vector<std::string>;

const Values kQuick{"ao=true", "ao.samples=2", "noise=0.02", "refine.passes=12"};

/// A scene whose window is known, with a mark that the program has drawn over it.
SavedScene marked(const scene::Snapshot& s) {
  SavedScene scene = sceneOf(s);
  scene.shown = {kSide, kSide, shownBy(s)};
  for (int y = 4; y < 12; ++y)
    for (int x = 8; x < 40; ++x) scene.shown.pixels[static_cast<size_t>(y * kSide + x)] = 0xff00ffff;
  return scene;
}

ViewCamera turnedBy(ViewCamera camera, double degrees) {
  const glm::dmat4 turn = glm::rotate(glm::dmat4(1), glm::radians(degrees), camera.up);
  camera.position = camera.focalPoint + glm::dvec3(turn * glm::dvec4(camera.position - camera.focalPoint, 0));
  return camera;
}

/// As `gluray render` makes it.
std::vector<uint32_t> rendered(const SavedScene& scene, const ViewRequest& request) {
  ShotOptions options{.size = request.size,
                      .overlays = !request.camera,
                      .camera = request.camera,
                      .settings = withValues(request.settings),
                      .edgeSamples = edgeSamplesFor(request.settings)};
  std::vector<scene::SnapshotPtr> batches;
  for (const SavedBatch& batch : scene.batches) batches.push_back(batch.snapshot);
  const ViewCamera saved = derivedCamera(batches)->camera;
  if (request.camera) options.known = std::make_shared<KnownView>(knownView(batches, {&saved, 1}, true));
  frame::Renderer renderer;
  Shot shot(scene, options, renderer);
  return test::rowsOf(shot);
}

struct Seen {
  std::vector<ViewStep> steps;
  std::vector<uint32_t> last;
  bool whole = false;
};

Seen looked(SceneView& view, const ViewRequest& request) {
  Seen seen;
  seen.whole = view.show(
      request, [] { return false; },
      [&](const ViewStep& step, const std::vector<uint32_t>& pixels) {
        seen.steps.push_back(step), seen.last = pixels;
      });
  return seen;
}

void expectAsRendered(SceneView& view, const ViewRequest& request, const std::string& what) {
  const Seen seen = looked(view, request);
  ASSERT_TRUE(seen.whole) << what;
  EXPECT_TRUE(seen.steps.back().finished) << what;
  EXPECT_TRUE(seen.last == rendered(view.scene(), request)) << what;
}

TEST(SceneView, FinishedPicturesAreThoseOfShots) {
  scene::Snapshot lit = balls(kSide), plain = unlit(balls(kSide, Floor::none));
  lit.settings.noise = 0.02f, lit.settings.ao.samples = 2, lit.settings.refine.passes = 10;
  for (const scene::Snapshot& s : {lit, plain, averaged(plain), layered(plain)}) {
    SceneView view(marked(s));
    ASSERT_TRUE(view.camera());
    const ViewCamera turned = turnedBy(view.camera()->camera, 50);
    // In turns, as somebody changes what is shown.
    expectAsRendered(view, {{kSide, kSide}, {}, {}}, "as saved");
    expectAsRendered(view, {{90, 70}, turned, {}}, "turned");
    expectAsRendered(view, {{90, 70}, turned, kQuick}, "turned, with other settings");
    expectAsRendered(view, {{50, 80}, {}, kQuick}, "as saved, with other settings");
    expectAsRendered(view, {{50, 80}, turnedBy(turned, 9), {}}, "turned on");
    expectAsRendered(view, {{kSide, kSide}, {}, {}}, "as saved again");
  }
}

TEST(SceneView, ExposuresAreThoseOfTheSavedView) {
  scene::Snapshot s = balls(kSide);
  s.settings.noise = 0.02f, s.settings.ao.samples = 2, s.settings.autoExposure = true;
  SceneView view(marked(s));
  const ViewCamera turned = turnedBy(view.camera()->camera, 50);
  Values bright = kQuick;
  bright.emplace_back("lights=headlight+key"), bright.emplace_back("auto-exposure=true");
  for (const Values& values : {Values(), bright, Values(), bright})
    expectAsRendered(view, {{70, 70}, turned, values}, values.empty() ? "the program's" : "others");
}

TEST(SceneView, GetsBetterStepByStep) {
  scene::Snapshot s = balls(kSide);
  s.settings.ao.samples = 1, s.settings.noise = 0.01f;
  SceneView view(marked(s));
  const Seen seen = looked(view, {{kSide, kSide}, turnedBy(view.camera()->camera, 20), {}});
  ASSERT_GE(seen.steps.size(), 5u);
  EXPECT_EQ(seen.steps.front().passes, 1u);
  EXPECT_TRUE(std::isinf(seen.steps.front().noise));
  EXPECT_GT(seen.steps[4].noise, seen.steps.back().noise);
  EXPECT_LE(seen.steps.back().noise, 0.01);
}

TEST(SceneView, IsLeftWhenSomethingElseIsWanted) {
  scene::Snapshot s = balls(kSide);
  s.settings.noise = 1e-9f, s.settings.refine.passes = 60;
  SceneView view(marked(s));
  std::atomic<int> left{40};
  int steps = 0;
  const bool whole = view.show(
      {{kSide, kSide}, {}, {}}, [&] { return --left < 0; },
      [&](const ViewStep& step, const auto&) {
        ++steps;
        EXPECT_FALSE(step.finished);
      });
  EXPECT_FALSE(whole);
  expectAsRendered(view,
                   {{kSide, kSide}, turnedBy(view.camera()->camera, 20), {"renderer=embree", "ao=false"}},
                   "the next");
}

TEST(SceneView, MovingFramesShowTheSame) {
  scene::Snapshot s = balls(kSide);
  s.settings.noise = 0.02f;
  SceneView view(marked(s));
  const ViewRequest request{{kSide, kSide}, turnedBy(view.camera()->camera, 30), {}};
  std::vector<uint32_t> moving;
  for (int i = 0; i < 4; ++i)
    view.showMoving(request, [&](const ViewStep& step, const auto& pixels) {
      moving = pixels;
      EXPECT_FALSE(step.finished);
    });
  const std::vector<uint32_t> still = looked(view, request).last;
  ASSERT_EQ(moving.size(), still.size());
  size_t others = 0;
  for (size_t i = 0; i < still.size(); ++i) others += apart(moving[i], still[i]) > 40;
  EXPECT_LT(others, still.size() / 20);
}

TEST(SceneView, FindsPoints) {
  SceneView view(sceneOf(unlit(balls(kSide, Floor::none))));
  const DerivedCamera& camera = *view.camera();
  for (const double degrees : {0.0, 25.0}) {
    ViewRequest request{{2 * kSide, 2 * kSide}, {}, {}};
    if (degrees != 0) request.camera = turnedBy(camera.camera, degrees);
    const ViewCamera& seen = request.camera ? *request.camera : camera.camera;
    const auto point = view.pointAt(request, {kSide, kSide});
    ASSERT_TRUE(point);
    // On the line of sight, up to half a pixel.
    const glm::dvec3 ahead = glm::normalize(seen.focalPoint - seen.position), to = *point - seen.position;
    EXPECT_GT(glm::dot(ahead, to), 1);
    EXPECT_LT(glm::length(to - glm::dot(ahead, to) * ahead), 0.02 * glm::length(to));
    EXPECT_FALSE(view.pointAt(request, {kSide, 0}));
  }
}

/// The camera is that of eye space, whatever the surfaces' own spaces are.
TEST(SceneView, KnowsTheCameraBesideStretchedObjects) {
  scene::Snapshot s = unlit(balls(kSide, Floor::none));
  for (scene::Instance& instance : s.instances)
    instance.eyeFromObject =
        instance.eyeFromObject * glm::scale(glm::translate(glm::dmat4(1), {0.1, 0.1, -0.2}), {2, 0.5, 3});
  SceneView view(sceneOf(s));
  ASSERT_TRUE(view.camera());
  const ViewCamera& camera = view.camera()->camera;
  const glm::dmat4& eye = view.camera()->known.eyeFromWorld;
  const glm::dvec3 place(eye * glm::dvec4(camera.position, 1)), focal(eye * glm::dvec4(camera.focalPoint, 1)),
      up(eye * glm::dvec4(camera.up, 0));
  EXPECT_NEAR(glm::length(place), 0, 1e-6);
  EXPECT_NEAR(glm::dot(glm::normalize(focal), glm::dvec3(0, 0, -1)), 1, 1e-9);
  EXPECT_NEAR(up.y, 1, 1e-6);
  EXPECT_NEAR(camera.viewAngle, 35, 1e-6);
  expectAsRendered(view, {{kSide, kSide}, turnedBy(camera, 40), {}}, "turned");
}

TEST(SceneView, RefusesWhatItCannotShow) {
  scene::Snapshot sheared = unlit(balls(kSide));
  for (scene::Instance& instance : sheared.instances)
    instance.eyeFromObject[0] += 0.5 * instance.eyeFromObject[1];
  SceneView view(sceneOf(sheared));
  EXPECT_FALSE(view.camera());
  EXPECT_TRUE(looked(view, {{kSide, kSide}, {}, {}}).whole);
  EXPECT_THROW(looked(view, {{kSide, kSide}, ViewCamera{}, {}}), std::runtime_error);
  EXPECT_THROW(looked(view, {{kSide, kSide}, {}, {"nothing=1"}}), std::runtime_error);
  EXPECT_THROW(looked(view, {{0, 7}, {}, {}}), std::runtime_error);
}

}  // namespace
}  // namespace gluray::saved
