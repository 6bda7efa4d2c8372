// Random scenes, each drawn by the real OpenGL and through ours: the same answers, colours and depths. Prints
// the seeds of those that differ, and keeps their pictures.
//   gluray_fuzz_scenes [--seed N] [--scenes N] [--out FOLDER]
#include "tests/fuzz/scenes/scene.h"
#include "tests/reference/traced_context.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace gluray::fuzz {
namespace {

using test::OsmesaContext;
using test::Picture;
using test::TracedContext;

/// Lighting at vertices is rounded differently here and there; edges fall to either side.
constexpr scenes::Tolerance kTolerance = {6, 0.03, 3e-5f, "edges of many small triangles"};

bool same(const std::vector<float>& a, const std::vector<float>& b) {
  bool equal = a.size() == b.size();
  for (size_t i = 0; equal && i < a.size(); ++i) equal = std::abs(a[i] - b[i]) <= 1e-5f;
  return equal;
}

/// Empty where both OpenGLs agree about the scene.
std::string difference(uint64_t seed, const std::string& folder) {
  std::vector<float> expected, got;
  const auto real = OsmesaContext::create({kSceneSize, kSceneSize});
  drawScene(real->real(), seed, expected);
  const Picture plain = test::readPicture(real->real(), kSceneSize, kSceneSize);
  const TracedContext ours({kSceneSize, kSceneSize});
  drawScene(ours.gl(), seed, got);
  const Picture traced = ours.read();
  if (!same(expected, got)) return "answers differ";
  const test::Comparison c = compare(plain, traced, kTolerance);
  if (c.accepted) return "";
  if (!folder.empty()) test::writeFailure(folder, std::to_string(seed), plain, traced);
  return c.text;
}

int run(uint64_t first, uint64_t count, const std::string& folder) {
  uint64_t differing = 0;
  for (uint64_t seed = first; seed < first + count; ++seed) {
    const std::string why = difference(seed, folder);
    if (why.empty()) continue;
    ++differing;
    std::printf("scene %llu: %s\n", static_cast<unsigned long long>(seed), why.c_str());
    std::fflush(stdout);
  }
  std::printf("%llu scenes, %llu differ\n", static_cast<unsigned long long>(count),
              static_cast<unsigned long long>(differing));
  return differing ? 1 : 0;
}

}  // namespace
}  // namespace gluray::fuzz

int main(int argc, char** argv) {
  uint64_t seed = 1, scenes = 100;
  std::string folder;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string_view option = argv[i];
    if (option == "--seed") seed = std::strtoull(argv[i + 1], nullptr, 10);
    if (option == "--scenes") scenes = std::strtoull(argv[i + 1], nullptr, 10);
    if (option == "--out") folder = argv[i + 1];
  }
  return gluray::fuzz::run(seed, scenes, folder);
}
