// A sort-last program: ranks that draw parts of one scene, and an image composed of theirs. For tests.
#pragma once
#include "cluster/testing/job_fixture.h"
#include "render/testing/lit_wall.h"
#include "scene/box_corner.h"

#include <algorithm>
#include <future>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace gluray::cluster::test {

/// A wall, and plates before it that darken it and each other.
inline scene::Snapshot plates(int size = 100) {
  using gluray::test::parallelogram;
  std::vector<scene::MeshPtr> meshes = {gluray::test::wall(3)};
  for (int i = 0; i < 7; ++i) {
    const float t = static_cast<float>(i);
    meshes.push_back(parallelogram({0.4f * t - 1.3f, 0.3f * t - 0.9f, 0.2f + 0.1f * t},
                                   {0.3f, 0.05f * t, 0.1f}, {-0.15f, 0.4f, 0.03f * t}));
  }
  scene::Snapshot s = gluray::test::litView(meshes, gluray::test::Shader::fixedFunction, {0.4f, 0.5f, 1, 0});
  s.shadings[0].globalAmbient = {0.5f, 0.5f, 0.5f, 1};
  for (scene::Instance& instance : s.instances) instance.materials[0].front.ambient = glm::vec4(1);
  s.camera.viewport = {0, 0, size, size}, s.region = {0, 0, size, size};
  s.settings.ao.enabled = true;
  s.settings.ao.samples = 4;
  return s;
}

/// What rank `rank` of `ranks` has of the scene: every so manieth instance.
inline scene::Snapshot partOf(const scene::Snapshot& all, int rank, int ranks) {
  scene::Snapshot part = all;
  part.instances.clear();
  for (size_t i = 0; i < all.instances.size(); ++i)
    if (static_cast<int>(i) % ranks == rank) part.instances.push_back(all.instances[i]);
  return part;
}

/// The ranks of one program.
class ProgramRanks {
 public:
  ProgramRanks(const std::string& directory, int ranks, int started) : ranks_(ranks) {
    for (int rank = 0; rank < started; ++rank)
      programs_.push_back(std::make_unique<Program>(directory, MpiPlace{rank, "mpi", rank, ranks}));
  }
  ProgramRanks(const std::string& directory, int ranks) : ProgramRanks(directory, ranks, ranks) {}

  /// Each rank's image of its part of the scene, traced at the same time.
  std::vector<Image> images(const std::vector<scene::Snapshot>& parts) {
    std::vector<std::future<Image>> coming;
    for (size_t i = 0; i < parts.size(); ++i)
      coming.push_back(std::async(std::launch::async, [&, i] { return programs_[i]->image(parts[i]); }));
    std::vector<Image> images;
    for (auto& one : coming) images.push_back(one.get());
    return images;
  }
  std::vector<Image> images(const scene::Snapshot& all) { return images(partsOfAll(all)); }
  std::vector<scene::Snapshot> partsOfAll(const scene::Snapshot& all) const {
    std::vector<scene::Snapshot> parts;
    for (size_t i = 0; i < programs_.size(); ++i) parts.push_back(partOf(all, static_cast<int>(i), ranks_));
    return parts;
  }
  Program& program(int rank) { return *programs_[static_cast<size_t>(rank)]; }
  void end(int rank) { programs_[static_cast<size_t>(rank)].reset(); }
  bool allByWorkers() const {
    return std::ranges::all_of(programs_, [](const auto& p) { return !p || p->tracedHere == 0; });
  }

 private:
  int ranks_;
  std::vector<std::unique_ptr<Program>> programs_;
};

/// As IceT composes opaque images.
inline Image composed(std::vector<Image> images) {
  Image all = std::move(images[0]);
  for (size_t k = 1; k < images.size(); ++k)
    for (size_t i = 0; i < all.depth.size(); ++i) {
      if (!(images[k].depth[i] < all.depth[i])) continue;
      all.depth[i] = images[k].depth[i];
      all.color[i] = images[k].color[i];
    }
  return all;
}

/// Where IceT takes pixels of a rank's image from: the box of the rank's data, on the screen.
inline glm::ivec4 boxOf(const scene::Snapshot& part) {
  glm::dvec3 lower(1e300), upper(-1e300);
  for (const scene::Instance& instance : part.instances)
    for (uint32_t vertex = 0; vertex < instance.mesh->vertexCount; ++vertex) {
      const glm::dvec3 point(glm::dmat4(instance.worldFromObject) *
                             glm::dvec4(instance.mesh->position(vertex), 1));
      lower = glm::min(lower, point), upper = glm::max(upper, point);
    }
  const scene::Region& region = part.region;
  glm::dvec2 least(1e300), most(-1e300);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec4 point(scene::boxCorner(lower, upper, corner), 1);
    const glm::dvec4 clip = part.camera.clipFromEye * part.eyeFromWorld * point;
    const glm::dvec2 pixel =
        (glm::dvec2(clip) / clip.w + 1.0) * 0.5 * glm::dvec2(region.width, region.height);
    least = glm::min(least, glm::floor(pixel)), most = glm::max(most, glm::ceil(pixel));
  }
  return {glm::max(least, glm::dvec2(0)), glm::min(most, glm::dvec2(region.width, region.height))};
}

/// As IceT composes the images of these parts. Returns how many pixels lie in no part's box.
inline int cropToBoxes(std::vector<Image>& images, const std::vector<scene::Snapshot>& parts) {
  std::vector<uint8_t> inside(images[0].depth.size());
  for (size_t k = 0; k < images.size(); ++k) {
    const glm::ivec4 box = boxOf(parts[k]);
    for (size_t i = 0; i < inside.size(); ++i) {
      const int x = static_cast<int>(i) % images[k].width, y = static_cast<int>(i) / images[k].width;
      if (x >= box.x && x < box.z && y >= box.y && y < box.w)
        inside[i] = 1;
      else
        images[k].depth[i] = Image::kMiss, images[k].color[i] = images[k].missColor;
    }
  }
  return static_cast<int>(std::ranges::count(inside, 0));
}

inline int differing(const Image& a, const Image& b) {
  int count = 0;
  for (size_t i = 0; i < a.color.size(); ++i) count += a.color[i] != b.color[i] || a.depth[i] != b.depth[i];
  return count;
}

/// The parts of these ranks as one scene, rank by rank.
inline scene::Snapshot partsOf(const scene::Snapshot& all, const std::vector<int>& some, int ranks) {
  scene::Snapshot parts = all;
  parts.instances.clear();
  for (const int rank : some)
    for (const scene::Instance& instance : partOf(all, rank, ranks).instances)
      parts.instances.push_back(instance);
  return parts;
}

}  // namespace gluray::cluster::test
