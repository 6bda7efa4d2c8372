// gluray-scene-player --out FOLDER [SCENE ...]: draws scenes in a window and writes their images.
// gluray-scene-player --compare EXPECTED GOT: compares two such folders by the scenes' tolerances.
#include "tests/reference/player/window.h"
#include "tests/support/drawn_image.h"

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

namespace gluray {
namespace {

constexpr int kWidth = 320, kHeight = 240;

std::string fileOf(const std::string& folder, const char* name) { return folder + "/" + name + ".image"; }

/// Colours, then depths, of kWidth x kHeight pixels, as in test::DrawnImage.
bool save(const std::string& file, const test::DrawnImage& image) {
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(image.colors.data()),
            static_cast<std::streamsize>(image.colors.size() * 4));
  out.write(reinterpret_cast<const char*>(image.depths.data()),
            static_cast<std::streamsize>(image.depths.size() * 4));
  return out.good();
}

bool load(const std::string& file, test::DrawnImage& image) {
  constexpr size_t kPixels = size_t{kWidth} * kHeight;
  image = {kWidth, kHeight, std::vector<uint32_t>(kPixels), std::vector<float>(kPixels)};
  std::ifstream in(file, std::ios::binary);
  in.read(reinterpret_cast<char*>(image.colors.data()), kPixels * 4);
  in.read(reinterpret_cast<char*>(image.depths.data()), kPixels * 4);
  return in.good();
}

int play(const std::string& folder, char** names, int count) {
  player::Window window(kWidth, kHeight);
  int failures = 0;
  for (const auto list : {scenes::scenes(), scenes::variants()})
    for (const scenes::Scene& scene : list) {
      bool wanted = count == 0;
      for (int i = 0; i < count; ++i) wanted |= std::strcmp(names[i], scene.name) == 0;
      if (!wanted) continue;
      window.freshContext();
      const gl::RealGl& gl = window.gl();
      scene.draw(gl, kWidth, kHeight);
      test::DrawnImage image{kWidth, kHeight, std::vector<uint32_t>(size_t{kWidth} * kHeight),
                             std::vector<float>(size_t{kWidth} * kHeight)};
      gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
      gl.ReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, image.colors.data());
      gl.ReadPixels(0, 0, kWidth, kHeight, GL_DEPTH_COMPONENT, GL_FLOAT, image.depths.data());
      window.swap();
      if (const GLenum error = gl.GetError()) {
        std::fprintf(stderr, "%s: OpenGL error 0x%x\n", scene.name, error);
        ++failures;
      }
      failures += !save(fileOf(folder, scene.name), image);
    }
  return failures ? 1 : 0;
}

int compareFolders(const std::string& expectedFolder, const std::string& gotFolder) {
  int failures = 0;
  for (const auto list : {scenes::scenes(), scenes::variants()})
    for (const scenes::Scene& scene : list) {
      test::DrawnImage expected, got;
      if (!load(fileOf(expectedFolder, scene.name), expected) || !load(fileOf(gotFolder, scene.name), got)) {
        std::printf("%-28s missing\n", scene.name);
        ++failures;
        continue;
      }
      const test::Comparison c = test::compare(expected, got, scene.tolerance);
      std::printf("%-28s %s %s\n", scene.name, c.accepted ? "ok  " : "FAIL", c.text.c_str());
      if (c.accepted) continue;
      ++failures;
      test::writeFailure(gotFolder, scene.name, expected, got);
    }
  std::printf("%d scenes differ\n", failures);
  return failures ? 1 : 0;
}

}  // namespace
}  // namespace gluray

int main(int argc, char** argv) {
  if (argc >= 3 && std::strcmp(argv[1], "--out") == 0) return gluray::play(argv[2], argv + 3, argc - 3);
  if (argc == 4 && std::strcmp(argv[1], "--compare") == 0) return gluray::compareFolders(argv[2], argv[3]);
  std::fprintf(stderr, "usage: gluray-scene-player --out FOLDER [SCENE ...] | --compare EXPECTED GOT\n");
  return 2;
}
