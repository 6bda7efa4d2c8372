// Random scenes, each drawn by the real OpenGL and through GLuRay: compares query results, colours and
// depths. Prints the seeds of scenes that differ, and keeps their images.
//   gluray_fuzz_scenes [--seed N] [--scenes N] [--out FOLDER]
#include "tests/fuzz/scenes/outcome.h"
#include "tests/fuzz/scenes/scene.h"
#include "tests/support/traced_context.h"

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace gluray::fuzz {
namespace {

using test::OsmesaContext;
using test::TracedContext;

/// Empty if both OpenGLs agree on the scene.
std::string differenceOf(uint64_t seed, const std::string& folder) {
  const auto real = OsmesaContext::create({kSceneSize, kSceneSize});
  const Outcome expected = outcomeOf(real->real(), seed);
  const TracedContext ours({kSceneSize, kSceneSize});
  return difference(seed, expected, outcomeOf(ours.gl(), seed), folder);
}

int run(uint64_t first, uint64_t count, const std::string& folder) {
  uint64_t differing = 0;
  for (uint64_t seed = first; seed < first + count; ++seed) {
    const std::string why = differenceOf(seed, folder);
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
