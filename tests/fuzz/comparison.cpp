#include "tests/fuzz/comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace gluray::fuzz {
namespace {

bool same(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) == std::isnan(b);
  return a == b || std::abs(a - b) <= 2e-5 * std::max({1.0, std::abs(a), std::abs(b)});
}

std::string text(const Answer& answer) {
  std::ostringstream out;
  out << answer.name << ":";
  for (double v : answer.values) out << ' ' << v;
  return out.str();
}

const std::string kCurrentAttribute = " " + std::to_string(GL_CURRENT_VERTEX_ATTRIB);  // "attribute 12 34342"

/// Integer attributes become floats by a product or a quotient: OpenGL requires one part in 10^5
/// (2.1, 2.1.1). Everything else is compared to the bit.
void forgiveRounding(const test::GlState& expected, test::GlState& got) {
  for (auto& [name, values] : got) {
    const auto other = expected.find(name);
    const bool current = name.find("CURRENT_") != name.npos || name.find(kCurrentAttribute) != name.npos;
    if (!current || other == expected.end()) continue;
    if (std::equal(values.begin(), values.end(), other->second.begin(), other->second.end(),
                   [](double a, double b) { return std::abs(a - b) <= 1e-6 * std::abs(a); }))
      values = other->second;
  }
}

bool near(uint32_t a, uint32_t b) {
  for (int shift = 0; shift < 32; shift += 8)
    if (std::abs(static_cast<int>(a >> shift & 255) - static_cast<int>(b >> shift & 255)) > 24) return false;
  return true;
}

}  // namespace

Outcome compareAnswers(const std::vector<Answer>& expected, const std::vector<Answer>& got) {
  for (size_t i = 0; i < std::min(expected.size(), got.size()); ++i) {
    const Answer &a = expected[i], &b = got[i];
    if (a.call == b.call && a.name == b.name &&
        std::equal(a.values.begin(), a.values.end(), b.values.begin(), b.values.end(), same))
      continue;
    return {"answers differ: " + text(a) + " -> " + text(b), a.call};
  }
  if (expected.size() == got.size()) return {};
  return {"different numbers of answers", 0};
}

Outcome compareState(const test::GlState& expected, test::GlState got) {
  forgiveRounding(expected, got);
  std::string all;
  for (const std::string& line : test::differences(expected, got))
    if (line.find("pointer") == line.npos && line.find("POINTER") == line.npos) all += "\n  " + line;
  if (all.empty()) return {};
  return {"state differs:" + all, 0};
}

/// Edges may be off by a pixel, and thousands of random triangles have many: only few pixels may have a
/// colour that the other image does not have nearby.
Outcome compareImages(const test::DrawnImage& expected, const test::DrawnImage& got) {
  const auto found = [](const test::DrawnImage& in, int x, int y, uint32_t color) {
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const int px = std::clamp(x + dx, 0, kSize - 1), py = std::clamp(y + dy, 0, kSize - 1);
        if (near(in.colors[static_cast<size_t>(py * kSize + px)], color)) return true;
      }
    return false;
  };
  int strange = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const auto at = static_cast<size_t>(y * kSize + x);
      strange += !found(expected, x, y, got.colors[at]) && !found(got, x, y, expected.colors[at]);
    }
  constexpr int kMax = kSize * kSize / 10;
  if (strange <= kMax) return {};
  return {"images differ in " + std::to_string(strange) + " pixels", 0};
}

}  // namespace gluray::fuzz
