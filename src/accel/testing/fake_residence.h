// Pages in memory that count how often they are loaded and dropped, for tests.
#pragma once
#include "accel/testing/test_scene.h"
#include "scene/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace gluray::test {

/// What all pages of a test share.
struct Store {
  size_t budget = 0;
  std::atomic<int> loads{0}, drops{0}, atOnce{0};
  std::atomic<bool> gone{false};  // loading fails
  std::atomic<int> failures{0};
};

/// Arrays that are zeros while they are not loaded.
class FakeResidence final : public scene::Residence {
 public:
  FakeResidence(Store& store, const MeshData& data, std::optional<Whole> whole)
      : store_(store), data_(data), whole_(whole) {
    positions_.resize(data.positions.size() + 2), indices_.resize(data.indices.size() + 5);
  }
  bool load() noexcept override {
    EXPECT_EQ(++inside_, 1);
    ++store_.loads;
    if (!store_.gone) {
      std::ranges::copy(data_.positions, positions_.begin());
      std::ranges::copy(data_.indices, indices_.begin());
    }
    --inside_;
    return !store_.gone;
  }
  void fail(const char*) noexcept override { ++store_.failures; }
  void drop() noexcept override {
    EXPECT_EQ(++inside_, 1);
    ++store_.drops;
    std::ranges::fill(positions_, glm::vec3(0)), std::ranges::fill(indices_, 0u);
    --inside_;
  }
  size_t bytes() const noexcept override { return positions_.size() * 12 + indices_.size() * 4; }
  const Whole* whole() const noexcept override { return whole_ ? &*whole_ : nullptr; }
  size_t budget() const noexcept override { return store_.budget; }

  scene::Attribute positions() const { return over(positions_.data(), 12, scene::Format::float3); }
  scene::Attribute indices() const { return over(indices_.data(), 4, scene::Format::uint32); }

 private:
  static scene::Attribute over(const void* data, uint32_t stride, scene::Format format) {
    return {std::shared_ptr<void>(), static_cast<const std::byte*>(data), stride, format};
  }
  Store& store_;
  const MeshData data_;
  const std::optional<Whole> whole_;
  std::vector<glm::vec3> positions_;
  std::vector<uint32_t> indices_;
  std::atomic<int> inside_{0};
};

/// A mesh with its bounds.
inline std::shared_ptr<scene::Mesh> bounded(const MeshData& data) {
  auto mesh = makeMesh(data);
  mesh->lower = glm::vec3(kInfinity), mesh->upper = glm::vec3(-kInfinity);
  for (const glm::vec3& p : data.positions)
    mesh->lower = glm::min(mesh->lower, p), mesh->upper = glm::max(mesh->upper, p);
  return mesh;
}

/// A page of the mesh.
inline std::shared_ptr<scene::Mesh> pageOf(const MeshData& data,
                                           const std::shared_ptr<FakeResidence>& residence) {
  auto page = bounded(data);
  page->positions = residence->positions(), page->indices = residence->indices();
  page->residence = residence;
  return page;
}

}  // namespace gluray::test
