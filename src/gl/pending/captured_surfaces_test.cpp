// Which pixels of a framebuffer may show surfaces.
#include "gl/pending/captured_surfaces.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <memory>

namespace gluray::gl {
namespace {

constexpr int kSide = 8;

scene::Instance boxAt(const glm::vec3& lower, const glm::vec3& upper) {
  auto mesh = std::make_shared<scene::Mesh>();
  mesh->lower = lower, mesh->upper = upper;
  scene::Instance instance;
  instance.mesh = mesh;
  return instance;
}

scene::FramebufferCapture captureWith(float depth) {
  scene::FramebufferCapture capture;
  capture.viewport = {0, 0, kSide, kSide};
  capture.region = {0, 0, kSide, kSide};
  capture.colors.assign(kSide * kSide, 7);
  capture.depths.assign(kSide * kSide, depth);
  return capture;
}

size_t pixelsLeft(const scene::FramebufferCapture& capture) {
  size_t count = 0;
  for (size_t i = 0; i < capture.depths.size(); ++i) {
    const bool there = capture.depths[i] != scene::FramebufferCapture::kNothing;
    EXPECT_EQ(capture.colors[i], there ? 7u : 0u);
    count += there;
  }
  return count;
}

/// The matrices are the identity: the window shows [-1, 1]^3, with depths from 0 to 1.
TEST(CapturedPixels, AreWhereBoundsAreInTheWindowAndInDepth) {
  scene::Snapshot s;
  s.instances = {boxAt({-0.99f, -0.99f, 0}, {-0.01f, -0.01f, 0.5f})};  // depths 0.5 to 0.75
  for (const float depth : {0.4f, 0.6f, 0.8f}) {
    scene::FramebufferCapture capture = captureWith(depth);
    leaveSurfaces(s, capture);
    EXPECT_EQ(pixelsLeft(capture), depth == 0.6f ? 16u : 0u) << depth;
  }
  s.instances.push_back(boxAt({0.01f, 0.01f, 0.5f}, {0.99f, 0.24f, 0.7f}));
  scene::FramebufferCapture capture = captureWith(0.75f);
  leaveSurfaces(s, capture);
  EXPECT_EQ(pixelsLeft(capture), 16u + 4u);
}

TEST(CapturedPixels, OfSeveralSurfacesAreNone) {
  // A slope along x, and in the middle samples of two surfaces.
  std::vector<float> nearest, farthest;
  for (int i = 0; i < 15; ++i) {
    nearest.push_back(0.5f + 0.01f * static_cast<float>(i % 5)), farthest.push_back(nearest.back() + 0.008f);
    if (i == 7) farthest.back() = 0.9f;
  }
  std::vector<float> merged = nearest;
  mergeSamples(5, farthest, 0x1p-24f, merged);
  for (size_t i = 0; i < merged.size(); ++i)
    EXPECT_EQ(merged[i], i == 7 ? scene::FramebufferCapture::kNothing : (nearest[i] + farthest[i]) / 2) << i;
}

/// An offset moves depths: then they say nothing.
TEST(CapturedPixels, KeepAllDepthsOfSurfacesWithAnOffset) {
  scene::Snapshot s;
  s.instances = {boxAt({-0.99f, -0.99f, 0}, {-0.01f, -0.01f, 0.5f})};
  scene::FramebufferCapture capture = captureWith(0.8f);
  capture.offset.factor = 1;
  leaveSurfaces(s, capture);
  EXPECT_EQ(pixelsLeft(capture), 16u);
}

TEST(CapturedPixels, AreAllWhereASurfaceReachesBehindTheViewer) {
  scene::Snapshot s;
  s.camera.clipFromEye = glm::perspective(1.0, 1.0, 0.1, 10.0);
  s.instances = {boxAt({-1, -1, -1}, {1, 1, 1})};
  scene::FramebufferCapture capture = captureWith(0.8f);
  leaveSurfaces(s, capture);
  EXPECT_EQ(pixelsLeft(capture), capture.depths.size());
}

}  // namespace
}  // namespace gluray::gl
