#include "tests/fuzz/scenes/outcome.h"

#include <GL/gl.h>

#include <cmath>
#include <fstream>

namespace gluray::fuzz {
namespace {

/// Tolerance: lighting at vertices is rounded differently in places, and edges may be off by a pixel.
constexpr scenes::Tolerance kTolerance = {6, 0.03, 3e-5f, "edges of many small triangles"};
constexpr size_t kPixels = size_t{kSceneSize} * kSceneSize;

/// Empty if both have answered alike.
std::string answersDiffer(const Answers& expected, const Answers& got) {
  if (expected.size() != got.size()) return "answers differ: not as many";
  for (size_t i = 0; i < got.size(); ++i)
    if (!(std::abs(expected[i] - got[i]) <= 1e-5f))
      return "answers differ: value " + std::to_string(i) + " is " + std::to_string(got[i]) + ", not " +
             std::to_string(expected[i]);
  return "";
}

test::DrawnImage emptyImage() {
  return {kSceneSize, kSceneSize, std::vector<uint32_t>(kPixels), std::vector<float>(kPixels)};
}

std::string fileOf(const std::string& folder, uint64_t seed) {
  return folder + "/" + std::to_string(seed) + ".outcome";
}

}  // namespace

Outcome outcomeOf(Gl gl, const std::vector<Call>& scene) {
  Outcome outcome{{}, emptyImage()};
  playScene(gl, scene, outcome.answers);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.ReadPixels(0, 0, kSceneSize, kSceneSize, GL_RGBA, GL_UNSIGNED_BYTE, outcome.image.colors.data());
  gl.ReadPixels(0, 0, kSceneSize, kSceneSize, GL_DEPTH_COMPONENT, GL_FLOAT, outcome.image.depths.data());
  return outcome;
}

std::string difference(uint64_t seed, const Outcome& expected, const Outcome& got,
                       const std::string& folder) {
  if (std::string why = answersDiffer(expected.answers, got.answers); !why.empty()) return why;
  const test::Comparison c = test::compare(expected.image, got.image, kTolerance);
  if (c.accepted) return "";
  if (!folder.empty()) test::writeFailure(folder, std::to_string(seed), expected.image, got.image);
  return c.text;
}

bool save(const std::string& folder, uint64_t seed, const Outcome& outcome) {
  std::ofstream out(fileOf(folder, seed), std::ios::binary);
  const auto put = [&](const void* data, size_t bytes) {
    out.write(static_cast<const char*>(data), static_cast<std::streamsize>(bytes));
  };
  const uint64_t answers = outcome.answers.size();
  put(&answers, sizeof answers);
  put(outcome.answers.data(), answers * sizeof(float));
  put(outcome.image.colors.data(), kPixels * sizeof(uint32_t));
  put(outcome.image.depths.data(), kPixels * sizeof(float));
  return out.good();
}

bool load(const std::string& folder, uint64_t seed, Outcome& outcome) {
  constexpr uint64_t kMaxAnswers = 1 << 20;
  std::ifstream in(fileOf(folder, seed), std::ios::binary);
  const auto get = [&](void* data, size_t bytes) {
    in.read(static_cast<char*>(data), static_cast<std::streamsize>(bytes));
  };
  uint64_t answers = 0;
  get(&answers, sizeof answers);
  if (!in || answers > kMaxAnswers) return false;
  outcome = {std::vector<float>(answers), emptyImage()};
  get(outcome.answers.data(), answers * sizeof(float));
  get(outcome.image.colors.data(), kPixels * sizeof(uint32_t));
  get(outcome.image.depths.data(), kPixels * sizeof(float));
  return in.good();
}

}  // namespace gluray::fuzz
