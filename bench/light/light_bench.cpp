// gluray-bench-light: what light beyond the local look costs, and how noisy moving frames are, on the
// Wavelet's isosurfaces at 1024x1024. One line a figure.
#include "bench/data/orbit.h"
#include "bench/data/png.h"
#include "bench/data/report.h"
#include "bench/light/rays.h"
#include "bench/light/stage.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <fstream>
#include <map>

namespace {

using namespace gluray;
using bench::Way;
using Mode = scene::LightSampling::Mode;

struct Options {
  bench::StageOptions stage;
  int frames = 24, rounds = 5, reference = 1024;
  bool quick = false, noRays = false;
  std::string dump, keep, only;
};

void figure(const char* name, double value, const char* unit) {
  std::printf("%-28s %10.3f %s\n", name, value, unit);
  std::fflush(stdout);
}

void dump(const Options& options, const char* name, const Image& image) {
  if (options.dump.empty()) return;
  std::vector<uint8_t> pixels(image.color.size() * 4);
  for (size_t i = 0; i < image.color.size(); ++i)
    for (size_t c = 0; c < 4; ++c)
      pixels[4 * i + c] = c == 3 ? 255 : static_cast<uint8_t>(image.color[i] >> (8 * c));
  bench::writePng(bench::pictureFromGl(image.width, image.height, pixels),
                  options.dump + "_" + name + ".png");
}

const Way kLocal{Mode::full, {}, 0, 0, false, false};
const Way kFull{Mode::moving, {1, false}, 1, 0, true, false},
    kQuarter{Mode::moving, {1, true}, 2, 0, true, false};
const Way kFirst{Mode::moving, {1, false}, 3, 0, true, true};

/// The picture to compare with, from the file if it is there.
void reference(const Options& options, bench::Stage& stage, Image& image) {
  std::ifstream in(options.keep, std::ios::binary);
  stage.trace(options.frames - 1, {Mode::full, {}, 0, in ? 1 : options.reference, true, false}, image);
  const auto bytes = static_cast<std::streamsize>(image.color.size() * 4);
  if (in && in.read(reinterpret_cast<char*>(image.color.data()), bytes)) return;
  if (!options.keep.empty())
    std::ofstream(options.keep, std::ios::binary)
        .write(reinterpret_cast<const char*>(image.color.data()), bytes);
}

/// Times of frames in turn, and the pictures of the last one.
void measure(const Options& options, bench::Stage& stage) {
  std::map<std::string, std::vector<double>> times, ratios;
  const std::map<std::string, Way> ways{
      {"moving_full", kFull}, {"moving_quarter", kQuarter}, {"first", kFirst}};
  std::map<std::string, Image> pictures;
  Image local;
  for (int frame = 0; frame < options.frames; ++frame) {
    const double base = stage.trace(frame, kLocal, local);
    times["local"].push_back(base);
    for (const auto& [name, way] : ways) {
      if (!options.only.empty() && options.only != name) continue;
      const double t = stage.trace(frame, way, pictures[name]);
      // The first frames have little history, and fewer pixels that need no rays.
      if (frame >= options.frames / 3) times[name].push_back(t), ratios[name].push_back(t / base);
    }
  }
  // Without rays: what history, filter and composition cost. After all others, whose history it uses.
  std::vector<double> rest;
  for (int round = 0; round < std::max(options.rounds, 5); ++round) {
    Way none = kFull;
    none.rays.perPixel = 0;
    Image unused;
    const double base = stage.trace(options.frames - 1, kLocal, local);
    rest.push_back((stage.trace(options.frames - 1, none, unused) - base) / base);
  }
  figure("without_rays_ratio", bench::median(rest), "of a local frame, added to it");
  Image converged;
  reference(options, stage, converged);
  figure("local_ms", 1e3 * bench::median(times["local"]), "ms");
  for (const auto& [name, way] : ways) {
    if (times[name].empty()) continue;
    figure((name + "_ms").c_str(), 1e3 * bench::median(times[name]), "ms");
    figure((name + "_ratio").c_str(), bench::median(ratios[name]), "of a local frame");
    figure((name + "_psnr").c_str(), bench::psnr(pictures[name], converged), "dB");
    dump(options, name.c_str(), pictures[name]);
  }
  figure("history_bytes_per_pixel", static_cast<double>(stage.historyBytes()) / 2 / (1024.0 * 1024), "bytes");
  dump(options, "local", local), dump(options, "reference", converged);
}

/// Occlusion rays a second: more rays a pixel, less one ray a pixel.
void compareRays(const Options& options, bench::Stage& stage) {
  constexpr int kMore = 5;
  const bench::BareRays bare =
      bench::shootBareRays(stage.mesh(), bench::orbitPose(0, 360), 2 * 0.1 * bench::kDataReach,
                           options.stage.threads, options.rounds);
  std::vector<double> seconds;
  Image image;
  for (int round = 0; round < options.rounds; ++round) {
    Way more = kFirst;
    more.rays.perPixel = kMore;
    const double one = stage.trace(0, kFirst, image);
    seconds.push_back(stage.trace(0, more, image) - one);
  }
  const double ours = (kMore - 1) * static_cast<double>(bare.rays) / bench::median(seconds);
  const double loop = static_cast<double>(bare.rays) / bare.seconds;
  figure("bare_occlusion_rays", loop * 1e-6, "Mray/s");
  figure("our_occlusion_rays", ours * 1e-6, "Mray/s");
  figure("occlusion_rays_ratio", ours / loop, "of the bare loop");
}

void run(Options options) {
  if (options.quick)
    options.frames = std::min(options.frames, 12), options.rounds = 3,
    options.reference = std::min(options.reference, 256);
  if (options.stage.settings.empty()) options.stage.settings = {"ao=on", "ao.samples=16"};
  bench::Stage stage(options.stage);
  figure("triangles", static_cast<double>(stage.mesh().triangleCount()) * 1e-6, "million");
  measure(options, stage);
  if (!options.noRays) compareRays(options, stage);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Times and noise of frames with light, on isosurfaces of the Wavelet.");
  app.add_option("--triangles", options.stage.millionTriangles, "millions of triangles, about")
      ->check(CLI::Range(0.1, 256.0));
  app.add_option("--threads", options.stage.threads, "0: one a core")->check(CLI::Range(0, 1024));
  app.add_option("--frames", options.frames, "frames of the orbit, a degree each")->check(CLI::Range(3, 360));
  app.add_option("--reference", options.reference, "samples of the picture to compare with")
      ->check(CLI::Range(1, 4096));
  app.add_option("--keep", options.keep,
                 "a file for that picture, of the same options: taken from there if it exists");
  app.add_option("--set", options.stage.settings, "NAME=VALUE: a setting (default: ao=on)");
  app.add_option("--only", options.only,
                 "of the moving ways this alone, for profilers: first, moving_full, moving_quarter");
  app.add_flag("--quick", options.quick, "fewer frames, a noisier reference");
  app.add_flag("--no-rays", options.noRays, "leave the bare loop out");
  app.add_option("--dump", options.dump, "write pictures: the beginning of their names");
  CLI11_PARSE(app, argc, argv);
  try {
    run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gluray-bench-light: %s\n", error.what());
    return 1;
  }
  return 0;
}
