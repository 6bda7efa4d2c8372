// Writes sample scenes in every format, and what GLuRay shows of them, for read_back.py; or measures how long
// a large scene takes.
//   gluray-export-samples FOLDER
//   gluray-export-samples --large TRIANGLES FILE
#include "frame/tracing/renderer.h"
#include "saved/export/export_scene.h"
#include "saved/testing/libpng_encoder.h"
#include "tests/saved/sample_scenes.h"
#include "tests/support/drawn_image.h"

#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>

using namespace gluray;

namespace {

/// Prints notes and errors.
bool isWritten(const saved::ExportResult& result) {
  for (const std::string& note : result.notes) printf("  %s\n", note.c_str());
  if (!result.written) fprintf(stderr, "%s\n", result.why.c_str());
  return result.written;
}

bool writePicture(const scene::Snapshot& s, const std::string& file) {
  frame::Renderer renderer;
  Image image;
  scene::TraceCost cost;
  std::string error;
  if (!renderer.render(s, image, cost, error)) {
    fprintf(stderr, "%s\n", error.c_str());
    return false;
  }
  test::DrawnImage drawn{image.width, image.height, image.color, image.depth};
  for (size_t i = 0; i < drawn.colors.size(); ++i)
    if (drawn.depths[i] == Image::kMiss) drawn.colors[i] = 0xFF000000;
  return test::writePng(file, drawn);
}

int writeAll(const std::string& folder) {
  mkdir(folder.c_str(), 0755);
  for (const test::SampleScene& sample : test::sampleScenes()) {
    printf("%s\n", sample.name.c_str());
    const std::string stem = folder + "/" + sample.name;
    for (const char* ending : {".glb", ".obj", ".ply"})
      if (!isWritten(saved::exportScene({sample.snapshot}, stem + ending, *saved::sceneFormatOf(ending),
                                        saved::test::encodePng)))
        return 1;
    if (!writePicture(*sample.snapshot, stem + ".png")) return 1;
  }
  return 0;
}

int measure(const std::string& triangles, const std::string& file) {
  const scene::SnapshotPtr s = test::largeScene(static_cast<uint32_t>(std::stoul(triangles)));
  for (int i = 0; i < 5; ++i) {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t before = std::clock();
    const auto format = saved::sceneFormatOf(file);
    if (!format || !isWritten(saved::exportScene({s}, file, *format, saved::test::encodePng))) return 1;
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    struct stat status {};
    stat(file.c_str(), &status);
    printf("%u triangles, %lld MB: %.2f s, %.2f s of processors\n", s->instances[0].mesh->triangleCount,
           static_cast<long long>(status.st_size >> 20), took.count(),
           static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
  }
  return 0;
}

}  // namespace

int main(int count, char** words) {
  if (count == 4 && std::string(words[1]) == "--large") return measure(words[2], words[3]);
  if (count == 2 && words[1][0] != '-') return writeAll(words[1]);
  fprintf(stderr, "usage: gluray-export-samples FOLDER | --large TRIANGLES FILE\n");
  return 2;
}
