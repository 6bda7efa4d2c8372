// Random scenes, each drawn by the real OpenGL and through GLuRay: compares query results, colours and
// depths. Prints the seeds of scenes that differ, and keeps their images.
//   gluray_fuzz_scenes [--seed N] [--scenes N] [--lists 1] [--out FOLDER]
//   gluray_fuzz_scenes [--lists 1] --print N   prints the calls of scene N
//   gluray_fuzz_scenes --shrink N [--lists 1] [--out FOLDER]   prints the calls of scene N that suffice to
//   make it differ
#include "tests/fuzz/scenes/outcome.h"
#include "tests/fuzz/scenes/scene.h"
#include "tests/fuzz/scenes/shrink.h"
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
std::string differenceOf(const std::vector<Call>& scene, uint64_t seed, const std::string& folder) {
  const auto real = OsmesaContext::create({kSceneSize, kSceneSize});
  const Outcome expected = outcomeOf(real->real(), scene);
  const TracedContext ours({kSceneSize, kSceneSize});
  return difference(seed, expected, outcomeOf(ours.gl(), scene), folder);
}

/// Prints how many draws of the scene are traced, and why others are not.
void printDecisions(const std::vector<Call>& scene) {
  const TracedContext ours({kSceneSize, kSceneSize});
  Answers answers;
  playScene(ours.gl(), scene, answers);
  ours.gl().Finish();
  const gl::Statistics& counted = ours.context().counts.statistics;
  std::printf("%llu draws traced\n", static_cast<unsigned long long>(counted.drawsTraced));
  for (size_t i = 0; i < counted.rasterisedBecause.size(); ++i)
    if (const uint64_t draws = counted.rasterisedBecause[i])
      std::printf("%llu rasterised: %s\n", static_cast<unsigned long long>(draws),
                  std::string(describe(static_cast<gl::Reason>(i))).c_str());
}

int shrinkScene(uint64_t seed, bool lists, const std::string& folder) {
  // Colours, depths, or the same wrong answer to a query.
  const auto kindOf = [](const std::string& why) {
    const size_t values = why.find(" is ");
    return why.starts_with("answers") && values != std::string::npos ? why.substr(values)
                                                                     : why.substr(0, why.find_first_of(":;"));
  };
  const std::string why = differenceOf(makeScene(seed, lists), seed, "");
  if (why.empty()) return std::printf("scene %llu is fine\n", static_cast<unsigned long long>(seed)), 0;
  const std::vector<Call> scene = shrink(makeScene(seed, lists), [&](const std::vector<Call>& less) {
    return kindOf(differenceOf(less, seed, "")) == kindOf(why);
  });
  for (const Call& call : scene) std::printf("%s\n", call.text().c_str());
  std::printf("scene %llu: %s\n", static_cast<unsigned long long>(seed),
              differenceOf(scene, seed, folder).c_str());
  printDecisions(scene);
  return 1;
}

int run(uint64_t first, uint64_t count, bool lists, const std::string& folder) {
  uint64_t differing = 0;
  for (uint64_t seed = first; seed < first + count; ++seed) {
    const std::string why = differenceOf(makeScene(seed, lists), seed, folder);
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
  uint64_t seed = 1, scenes = 100, shrunk = 0, lists = 0;
  std::string folder;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string_view option = argv[i];
    if (option == "--seed") seed = std::strtoull(argv[i + 1], nullptr, 10);
    if (option == "--scenes") scenes = std::strtoull(argv[i + 1], nullptr, 10);
    if (option == "--shrink") shrunk = std::strtoull(argv[i + 1], nullptr, 10);
    if (option == "--print") {
      for (const auto& call : gluray::fuzz::makeScene(std::strtoull(argv[i + 1], nullptr, 10), lists != 0))
        std::printf("%s\n", call.text().c_str());
      return 0;
    }
    if (option == "--lists") lists = std::strtoull(argv[i + 1], nullptr, 10);
    if (option == "--out") folder = argv[i + 1];
  }
  return shrunk ? gluray::fuzz::shrinkScene(shrunk, lists != 0, folder)
                : gluray::fuzz::run(seed, scenes, lists != 0, folder);
}
