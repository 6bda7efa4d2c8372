#include "render/paths/space_colors.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {

void SpaceColors::prepare(const glm::vec3& lower, const glm::vec3& upper, size_t points) {
  constexpr int kFinest = 6;       // 64 cells along the longest side
  constexpr double kOfAPoint = 8;  // cells: bounds memory
  const glm::vec3 extent = glm::max(upper - lower, glm::vec3(0));
  const float longest = std::max({extent.x, extent.y, extent.z});
  lower_ = lower;
  const auto sizeAt = [&](int level) {
    const float cells = static_cast<float>(1 << level);
    return longest > 0 ? glm::ivec3(glm::clamp(glm::ceil(extent / longest * cells), 1.0f, cells))
                       : glm::ivec3(1);
  };
  const auto count = [](const glm::ivec3& s) { return double(s.x) * s.y * s.z; };
  // As many cells across the surface as it has points, at most.
  int level = std::clamp(static_cast<int>(std::log2(std::max<double>(1, static_cast<double>(points))) / 2), 0,
                         kFinest);
  while (level > 0 && count(sizeAt(level)) > kOfAPoint * static_cast<double>(points)) --level;
  cellsOfUnit_ = longest > 0 ? static_cast<float>(1 << level) / longest : 0;
  levels_.assign(1, {});
  Level& finest = levels_.front();
  finest.size = sizeAt(level);
  finest.cells.assign(static_cast<size_t>(count(finest.size)), glm::vec4(0));
}

void SpaceColors::add(const glm::vec3& point, const glm::vec3& color) {
  Level& finest = levels_.front();
  const glm::vec3 most(finest.size - 1);
  finest.cell(glm::ivec3(glm::clamp(glm::floor((point - lower_) * cellsOfUnit_), glm::vec3(0), most))) +=
      glm::vec4(color, 1);
}

/// Half of what cells have on average that have any: so colours fade where points end.
float SpaceColors::Level::halfOfMean() const {
  double points = 0, filled = 0;
  for (const glm::vec4& cell : cells)
    if (cell.w > 0) points += double{cell.w}, ++filled;
  return filled > 0 ? static_cast<float>(points / filled / 2) : 1;
}

void SpaceColors::finish() {
  while (levels_.back().size != glm::ivec3(1)) {
    const Level& fine = levels_.back();
    Level coarse;
    coarse.size = (fine.size + 1) / 2;
    coarse.cells.assign(static_cast<size_t>(coarse.size.x) * static_cast<size_t>(coarse.size.y) *
                            static_cast<size_t>(coarse.size.z),
                        glm::vec4(0));
    glm::ivec3 at;
    for (at.z = 0; at.z < fine.size.z; ++at.z)
      for (at.y = 0; at.y < fine.size.y; ++at.y)
        for (at.x = 0; at.x < fine.size.x; ++at.x) coarse.cell(at / 2) += fine.cells[fine.index(at)];
    levels_.push_back(std::move(coarse));
  }
  if (!(levels_.back().cells[0].w > 0)) return levels_.clear();
  for (Level& level : levels_) level.enough = level.halfOfMean();
}

/// `at`: in cells from the lower corner.
glm::vec4 SpaceColors::Level::interpolated(const glm::vec3& at) const {
  const glm::vec3 first = glm::floor(at - 0.5f), share = at - 0.5f - first;
  glm::vec4 sum(0);
  for (int k = 0; k < 8; ++k) {
    const glm::ivec3 step(k & 1, k >> 1 & 1, k >> 2);
    const glm::ivec3 where = glm::clamp(glm::ivec3(first) + step, glm::ivec3(0), size - 1);
    float weight = 1;
    for (int c = 0; c < 3; ++c) weight *= step[c] ? share[c] : 1 - share[c];
    sum += weight * cells[index(where)];
  }
  return sum;
}

glm::vec3 SpaceColors::at(const glm::vec3& point) const {
  constexpr float kLittle = 0.004f;  // of a colour, less than a step of a byte
  glm::vec3 color(0);
  float left = 1, cells = cellsOfUnit_;
  // Far outside the box cells are those of its rim.
  constexpr float kFar = 1e6f;
  for (const Level& level : levels_) {
    const glm::vec4 sum = level.interpolated(glm::clamp((point - lower_) * cells, -kFar, kFar));
    const bool last = level.size == glm::ivec3(1);
    const float known = last ? 1 : std::min(1.0f, sum.w / level.enough);
    if (sum.w > 0) color += left * known * glm::vec3(sum) / sum.w, left *= 1 - known;
    if (left < kLittle) break;
    cells /= 2;
  }
  return color / (1 - left);
}

}  // namespace gluray::render
