// gluray-bench-paper-data: writes one of the data sets of the paper's evaluation as a file for its programs.
#include "bench/paper/paper_data.h"

#include "bench/data/isosurface.h"
#include "bench/data/mesh_file.h"
#include "bench/data/wavelet.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <functional>
#include <map>

namespace {

using namespace gluray::bench;

TriangleMesh waveletSurfacesOf(double millions) {
  const Volume volume = wavelet();
  const auto [low, high] = volume.range();
  return isosurfaces(volume, evenIsovalues(low, high, waveletSurfaces(millions)));
}

}  // namespace

int main(int argc, char** argv) {
  const std::map<std::string, std::function<TriangleMesh(double)>> makers = {
      {"wavelet", waveletSurfacesOf}, {"plasma", plasma}, {"mixing", mixingInterface}, {"star", star}};
  std::string name, out;
  double millions = 1;
  CLI::App app("Writes one of the data sets of the paper's evaluation; prints its size as JSON.");
  app.add_option("name", name, "wavelet, plasma, mixing or star")->required()->check(CLI::IsMember(makers));
  app.add_option("--millions", millions, "millions of triangles, about")->check(CLI::Range(0.001, 400.0));
  app.add_option("--out", out, "file to write")->required();
  CLI11_PARSE(app, argc, argv);
  try {
    const TriangleMesh mesh = makers.at(name)(millions);
    writeMesh(mesh, out);
    std::printf("{\"name\": \"%s\", \"triangles\": %zu, \"vertices\": %zu}\n", name.c_str(),
                mesh.triangleCount(), mesh.positions.size());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gluray-bench-paper-data: %s\n", error.what());
    return 1;
  }
  return 0;
}
