// Pictures of saved scenes from cameras of paths.
#include "saved/shot/path_view.h"

#include "saved/testing/saved_pictures.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace gluray::saved {
namespace {

using frame::test::balls, frame::test::Floor;
using namespace test;

const ViewCamera kSaved{{0.5, 1, 6}, {0.1, 0, 0}, {0, 1, 0}, 35, 1},
    kOther{{4, 2, -3}, {0, 0.2, 0}, {0.1, 1, 0}, 50, 1};
const ViewCamera kFlat{{0.5, 1, 6}, {0.1, 0, 0}, {0, 1, 0}, 0, 2},
    kFlatOther{{4, 2, -3}, {0, 0.2, 0}, {0.1, 1, 0}, 0, 3};

glm::dmat4 projectionOf(const ViewCamera& c) {
  if (c.isParallel())
    return glm::ortho(-c.parallelScale, c.parallelScale, -c.parallelScale, c.parallelScale, 0.1, 50.0);
  return glm::perspective(glm::radians(c.viewAngle), 1.0, 0.1, 50.0);
}

/// Balls in a world that a camera sees. `worldFromObject`: of all surfaces.
scene::Snapshot seenBy(const ViewCamera& c, const glm::dmat4& worldFromObject = glm::dmat4(1)) {
  scene::Snapshot s = balls(kSide, Floor::none);
  s.settings.ao.enabled = false;
  s.camera.clipFromEye = projectionOf(c);
  s.eyeFromWorld = glm::lookAt(c.position, c.focalPoint, c.up) * worldFromObject;
  for (scene::Instance& instance : s.instances) instance.eyeFromObject = s.eyeFromWorld;
  return s;
}

std::vector<uint32_t> pathPicture(const SavedScene& scene, const ViewCamera& camera,
                                  std::vector<ViewCamera> saved, bool stated = false) {
  std::vector<scene::SnapshotPtr> batches;
  for (const SavedBatch& batch : scene.batches) batches.push_back(batch.snapshot);
  ShotOptions options{.overlays = false, .camera = camera};
  options.known = std::make_shared<KnownView>(knownView(batches, saved, stated));
  return pictureOf(scene, options);
}

/// Whether the pictures differ by rounding alone, and show something.
void expectAlike(const std::vector<uint32_t>& got, const std::vector<uint32_t>& wanted) {
  ASSERT_EQ(got.size(), wanted.size());
  size_t differing = 0, shown = 0;
  for (size_t i = 0; i < got.size(); ++i) differing += apart(got[i], wanted[i]) > 2, shown += wanted[i] != 0;
  EXPECT_LT(differing, 12u);
  EXPECT_GT(shown, 150u);
}

std::string refusalOf(const SavedScene& scene, const ViewCamera& camera, const std::vector<ViewCamera>& saved,
                      bool stated = false) {
  try {
    pathPicture(scene, camera, saved, stated);
  } catch (const std::runtime_error& e) { return e.what(); }
  return "";
}

TEST(ViewCamera, IsFoundInMatrices) {
  for (const ViewCamera& c : {kSaved, kOther, kFlat, kFlatOther}) {
    const glm::dmat4 view = *cameraFromWorld(c);
    const glm::dmat4 wanted = glm::lookAt(c.position, c.focalPoint, c.up);
    for (int i = 0; i < 4; ++i) EXPECT_LT(glm::length(view[i] - wanted[i]), 1e-12);
    const auto seen = seenCamera(projectionOf(c) * view);
    ASSERT_TRUE(seen);
    EXPECT_EQ(seen->parallel, c.isParallel());
    EXPECT_NEAR(seen->halfHeight, halfHeightOf(c), 1e-9);
    EXPECT_NEAR(glm::dot(seen->back, glm::normalize(c.position - c.focalPoint)), 1, 1e-9);
    EXPECT_TRUE(areAlike(*seen, c, 1e-6));
    ViewCamera moved = c;
    moved.position += glm::dvec3(0.1, 0, 0);
    EXPECT_FALSE(areAlike(*seen, moved, 1e-3));
    ViewCamera narrower = c;
    narrower.viewAngle *= 0.99, narrower.parallelScale *= 0.99;
    EXPECT_FALSE(areAlike(*seen, narrower, 1e-3));
  }
  EXPECT_FALSE(cameraFromWorld({{1, 2, 3}, {1, 2, 3}, {0, 1, 0}}));
  EXPECT_FALSE(cameraFromWorld({{0, 5, 0}, {0, 0, 0}, {0, 2, 0}}));
  EXPECT_FALSE(seenCamera(glm::dmat4(0)));
}

TEST(PathView, ProjectsPointsAsTheCameraDoes) {
  for (const auto& [saved, other] : {std::pair(kSaved, kOther), std::pair(kFlat, kFlatOther)}) {
    const std::vector<scene::SnapshotPtr> batches = {std::make_shared<scene::Snapshot>(seenBy(saved))};
    const KnownView known = knownView(batches, std::vector{saved}, false);
    const auto views = seenFrom(batches, known, other);
    const glm::dmat4 got = views[0]->camera.clipFromEye * views[0]->instances[0].eyeFromObject,
                     wanted = projectionOf(other) * glm::lookAt(other.position, other.focalPoint, other.up);
    for (const glm::dvec3 p :
         {glm::dvec3(0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0.5), glm::dvec3(-0.7, 0.3, 1)}) {
      const glm::dvec4 a = got * glm::dvec4(p, 1), b = wanted * glm::dvec4(p, 1);
      EXPECT_NEAR(a.x / a.w, b.x / b.w, 1e-9);
      EXPECT_NEAR(a.y / a.w, b.y / b.w, 1e-9);
    }
    for (const scene::Instance& i : views[0]->instances)  // between the planes
      for (int c = 0; c < 8; ++c) {
        const glm::vec3 p(c & 1 ? i.mesh->upper.x : i.mesh->lower.x,
                          c & 2 ? i.mesh->upper.y : i.mesh->lower.y,
                          c & 4 ? i.mesh->upper.z : i.mesh->lower.z);
        const glm::dvec4 clip = views[0]->camera.clipFromEye * i.eyeFromObject * glm::dvec4(p, 1);
        EXPECT_LE(std::abs(clip.z), clip.w * (1 + 1e-9));
      }
  }
}

TEST(PathView, OfTheSavedCameraIsTheSavedView) {
  for (const ViewCamera& camera : {kSaved, kFlat}) {
    const SavedScene scene = sceneOf(seenBy(camera));
    EXPECT_EQ(pathPicture(scene, camera, {kOther, camera}), pictureOf(scene, {.overlays = false}));
    ViewCamera hair = camera;
    hair.position.x += 1e-7;
    expectAlike(pathPicture(scene, hair, {camera}), pictureOf(scene, {.overlays = false}));
  }
}

TEST(PathView, IsWhatTheProgramWouldShow) {
  expectAlike(pathPicture(sceneOf(seenBy(kSaved)), kOther, {kSaved}), shownBy(seenBy(kOther), 0));
  expectAlike(pathPicture(sceneOf(seenBy(kFlat)), kFlatOther, {kFlat}), shownBy(seenBy(kFlatOther), 0));
}

TEST(PathView, DoesNotAskWhereEyeSpaceIs) {
  const glm::dmat4 between = glm::rotate(glm::translate(glm::dmat4(1), {0.4, -0.3, 0.2}), 1.0, {1, 2, 3});
  for (const auto& [camera, other] : {std::pair(kSaved, kOther), std::pair(kFlat, kFlatOther)}) {
    scene::Snapshot s = seenBy(camera);
    s.camera.clipFromEye = s.camera.clipFromEye * between;
    s.eyeFromWorld = glm::inverse(between) * s.eyeFromWorld;
    for (scene::Instance& instance : s.instances) instance.eyeFromObject = s.eyeFromWorld;
    expectAlike(pathPicture(sceneOf(s), other, {camera}), shownBy(seenBy(other), 0));
    expectAlike(pathPicture(sceneOf(s), other, {camera}, true), shownBy(seenBy(other), 0));
  }
}

TEST(PathView, FindsTheWorldAmongObjects) {
  scene::Snapshot saved = seenBy(kSaved), other = seenBy(kOther);
  const glm::dmat4 own = glm::rotate(glm::translate(glm::dmat4(1), {1, 0.5, 0}), 0.7, {1, 2, 3});
  for (scene::Snapshot* s : {&saved, &other}) {
    ASSERT_GE(s->instances.size(), 2u);
    s->instances[0].eyeFromObject = s->eyeFromWorld * own;
  }
  expectAlike(pathPicture(sceneOf(saved), kOther, {kSaved}), shownBy(other, 0));
}

TEST(PathView, TakesStatedCamerasWhereAllSurfacesAreShifted) {
  const glm::dmat4 shift = glm::scale(glm::translate(glm::dmat4(1), {0.3, -0.2, 0.1}), {1.2, 1.2, 1.2});
  const SavedScene scene = sceneOf(seenBy(kSaved, shift));
  EXPECT_NE(refusalOf(scene, kOther, {kSaved}), "") << "it could be any";
  expectAlike(pathPicture(scene, kOther, {kSaved}, true), shownBy(seenBy(kOther, shift), 0));
  // Axes in different steps, so little that the camera seems to be in the space of the surfaces.
  const glm::dmat4 little = glm::scale(glm::dmat4(1), {0.9993, 1, 1.0005});
  expectAlike(pathPicture(sceneOf(seenBy(kSaved, little)), kOther, {kSaved}),
              shownBy(seenBy(kOther, little), 0));
  const SavedScene flat = sceneOf(seenBy(kFlat, shift));
  expectAlike(pathPicture(flat, kFlatOther, {kFlat}, true), shownBy(seenBy(kFlatOther, shift), 0));
}

TEST(PathView, TakesTheSpaceOfLightingForTheCameras) {
  // Eye space is the object space of surfaces, as where the real OpenGL gets one matrix; lighting has the
  // camera's own.
  const glm::dmat4 shift = glm::scale(glm::translate(glm::dmat4(1), {0.3, -0.2, 0.1}), {1.2, 0.8, 1.1});
  for (const auto& [camera, other] : {std::pair(kSaved, kOther), std::pair(kFlat, kFlatOther)}) {
    scene::Snapshot s = seenBy(camera, shift);
    for (scene::Instance& instance : s.instances)
      instance.lightingFromObject = glm::mat4(s.eyeFromWorld), instance.eyeFromObject = glm::dmat4(1);
    s.camera.clipFromEye = s.camera.clipFromEye * s.eyeFromWorld;
    s.eyeFromWorld = glm::dmat4(1);
    EXPECT_NE(refusalOf(sceneOf(s), other, {camera}), "");
    const std::vector<scene::SnapshotPtr> batches = {std::make_shared<scene::Snapshot>(s)};
    const auto views = seenFrom(batches, knownView(batches, std::vector{camera}, true), other);
    const glm::dmat4 got = views[0]->camera.clipFromEye * views[0]->instances[0].eyeFromObject,
                     wanted = projectionOf(other) * glm::lookAt(other.position, other.focalPoint, other.up) *
                              shift;
    for (const glm::dvec3 p : {glm::dvec3(0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0.5)}) {
      const glm::dvec4 a = got * glm::dvec4(p, 1), b = wanted * glm::dvec4(p, 1);
      EXPECT_NEAR(a.x / a.w, b.x / b.w, 1e-5);
      EXPECT_NEAR(a.y / a.w, b.y / b.w, 1e-5);
    }
  }
}

TEST(PathView, RefusesWhatIsNotKnown) {
  const SavedScene scene = sceneOf(seenBy(kSaved));
  EXPECT_NE(refusalOf(scene, kOther, {kOther}).find("--saved-camera"), std::string::npos);
  ViewCamera narrow = kSaved;
  narrow.viewAngle = 30;
  EXPECT_EQ(
      refusalOf(scene, kOther, {narrow}, true),
      "--saved-camera is not the camera of the saved view: it has view angle 30, the scene view angle 35");
  ViewCamera turned = kSaved;
  turned.up = {1, 1, 0};
  EXPECT_NE(refusalOf(scene, kOther, {turned}, true).find("no surface"), std::string::npos);
  EXPECT_NE(refusalOf(scene, kFlat, {kSaved}).find("parallel"), std::string::npos);
  ViewCamera blind = kOther;
  blind.focalPoint = blind.position;
  EXPECT_NE(refusalOf(scene, blind, {kSaved}).find("nowhere"), std::string::npos);
}

}  // namespace
}  // namespace gluray::saved
