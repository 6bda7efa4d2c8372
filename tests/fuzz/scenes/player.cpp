// gluray_fuzz_player --out FOLDER FIRST COUNT: draws the random scenes FIRST, FIRST+1, ... in a window, each
// in a fresh context, and keeps their outcomes. gluray_fuzz_player --compare EXPECTED GOT FIRST COUNT:
// compares two such folders, and prints the seeds that differ.
#include "tests/fuzz/scenes/outcome.h"
#include "tests/fuzz/scenes/scene.h"
#include "tests/reference/player/window.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace gluray::fuzz {
namespace {

struct Seeds {
  uint64_t first, end;
  Seeds(const char* from, const char* count) : first(std::strtoull(from, nullptr, 10)) {
    end = first + std::strtoull(count, nullptr, 10);
  }
};

int play(const std::string& folder, const Seeds& seeds) {
  player::Window window(kSceneSize, kSceneSize);
  for (uint64_t seed = seeds.first; seed < seeds.end; ++seed) {
    window.freshContext();
    const Outcome outcome = outcomeOf(window.gl(), makeScene(seed));
    window.swap();
    if (save(folder, seed, outcome)) continue;
    std::fprintf(stderr, "cannot write into %s\n", folder.c_str());
    return 1;
  }
  return 0;
}

int compareFolders(const std::string& expectedFolder, const std::string& gotFolder, const Seeds& seeds) {
  int differing = 0;
  for (uint64_t seed = seeds.first; seed < seeds.end; ++seed) {
    Outcome expected, got;
    const bool there = load(expectedFolder, seed, expected) && load(gotFolder, seed, got);
    const std::string why = there ? difference(seed, expected, got, gotFolder) : "missing";
    if (why.empty()) continue;
    ++differing;
    std::printf("scene %llu: %s\n", static_cast<unsigned long long>(seed), why.c_str());
  }
  std::printf("%d scenes differ\n", differing);
  return differing ? 1 : 0;
}

}  // namespace
}  // namespace gluray::fuzz

int main(int argc, char** argv) {
  using gluray::fuzz::Seeds;
  if (argc == 5 && std::strcmp(argv[1], "--out") == 0)
    return gluray::fuzz::play(argv[2], Seeds(argv[3], argv[4]));
  if (argc == 6 && std::strcmp(argv[1], "--compare") == 0)
    return gluray::fuzz::compareFolders(argv[2], argv[3], Seeds(argv[4], argv[5]));
  std::fprintf(stderr,
               "usage: gluray_fuzz_player --out FOLDER FIRST COUNT | --compare EXPECTED GOT FIRST COUNT\n");
  return 2;
}
