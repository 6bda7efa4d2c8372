// gluray-bench-light: what light beyond the local look costs, and how noisy images are, on the Wavelet's
// isosurfaces or on lines at 1024x1024. One line a figure.
#include "bench/data/image_error.h"
#include "bench/data/orbit.h"
#include "bench/data/png.h"
#include "bench/data/report.h"
#include "bench/light/compare_rays.h"
#include "bench/light/stage.h"
#include "frame/refinement/refiner.h"
#include "settings/layers/presets.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <map>
#include <stdexcept>

namespace {

using namespace gluray;
using bench::Way;
using Mode = scene::LightSampling::Mode;

struct Options {
  bench::StageOptions stage;
  std::vector<std::string> settings, shadows;
  int frames = 24, step = 1, rounds = 5, reference = 1024;
  bool quick = false, noRays = false, noRest = false;
  std::string dump, only, preset, size;
};

double secondsOf(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Measures with one set of settings, whose figures begin with a prefix.
class Measurement {
 public:
  Measurement(const Options& options, bench::Stage& stage, std::string prefix)
      : options_(options), stage_(stage), prefix_(std::move(prefix)) {}

  /// Times of frames in turn, and the noise of the last ones.
  void moving() {
    std::map<std::string, std::vector<double>> times, ratios, cpu;
    std::map<std::string, Image> images;
    std::vector<double> locals;
    Image local;
    for (int frame = 0; frame < options_.frames; ++frame) {
      const double base = stage_.trace(frame * options_.step, kLocal, local).wall;
      locals.push_back(base);
      for (const auto& [name, way] : kWays) {
        if (!options_.only.empty() && options_.only != name) continue;
        const bench::FrameTime t = stage_.trace(frame * options_.step, way, images[name]);
        // The first frames have little history, and fewer pixels that need no rays.
        if (frame < options_.frames / 3) continue;
        times[name].push_back(t.wall), ratios[name].push_back(t.wall / base), cpu[name].push_back(t.cpu);
      }
    }
    local_ = bench::median(locals);
    figure("local_ms", 1e3 * local_, "ms");
    if (options_.only.empty()) figure("without_rays_ratio", withoutRays(), "of a local frame, added to it");
    converge();
    for (const auto& [name, image] : images) {
      figure(name + "_ms", 1e3 * bench::median(times[name]), "ms");
      figure(name + "_cpu_ms", 1e3 * bench::median(cpu[name]), "ms of all threads");
      figure(name + "_ratio", bench::median(ratios[name]), "of a local frame");
      figure(name + "_psnr", errorOf(image), "dB");
      dump(name, image);
    }
    const double views = static_cast<double>(images.size());
    figure("history_bytes_per_pixel", static_cast<double>(stage_.historyBytes()) / views / stage_.pixels(),
           "bytes");
    dump("local", local), dump("reference", converged_);
  }

  /// Passes over a frame at rest until its error is 40 dB.
  void atRest() {
    constexpr int kMax = 256;
    frame::Refinement refinement;
    double seconds = 0, error = 0;
    for (uint32_t pass = 0; pass < kMax && error < kGoal; ++pass) {
      Way way = kFull;
      way.wide = true, way.pass = pass;
      way.more = {"ao.samples=" + std::to_string(kPassRays), "shadows.samples=" + std::to_string(kPassRays)};
      Image wide, image;
      seconds += stage_.trace(last(), way, wide).wall;
      seconds += secondsOf([&] { refinement.add(wide), refinement.show(wide, false, image); });
      error = errorOf(image);
    }
    figure("at_rest_psnr", error, "dB");
    figure("at_rest_rays", kPassRays * static_cast<double>(refinement.passes()), "a point");
    figure("at_rest_ratio", seconds / local_, "local frames");
  }

  /// The same with `denoise = filter`: passes, auxiliary features, and smoothing once, when the image is
  /// shown.
  void atRestSmoothed() {
    constexpr int kMax = 64, kRays = 2;
    const std::string count = std::to_string(kRays);
    frame::Refinement refinement;
    frame::Refiner refiner(
        stage_.at(last(), {"ao.samples=" + count, "shadows.samples=" + count, "denoise=filter"}), refinement);
    const frame::Trace trace = [&](const scene::Snapshot& s, Image& image, scene::TraceCost&, std::string&) {
      return stage_.trace(s, image) >= 0;
    };
    double passes = 0, show = 0, error = 0;
    for (int pass = 0; pass < kMax && error < kGoal; ++pass) {
      scene::TraceCost cost;
      std::string why;
      Image image;
      passes += secondsOf([&] { refiner.pass(trace, 0, cost, why); });
      show = secondsOf([&] { refiner.show(image); });
      error = errorOf(image);
    }
    figure("at_rest_smoothed_psnr", error, "dB");
    figure("at_rest_smoothed_rays", kRays * static_cast<double>(refinement.passes()), "a point");
    figure("at_rest_smoothed_ratio", (passes + show) / local_, "local frames");
  }

 private:
  static constexpr int kPassRays = 8;
  static constexpr double kGoal = 40;  // dB, at rest
  static inline const Way kLocal{Mode::full, {}, 0, false, {"ao=off", "shadows=off"}};
  static inline const Way kFull{Mode::full, {}, 0, false, {}};
  static inline const std::map<std::string, Way> kWays{{"moving_full", {Mode::moving, {1, false}, 1}},
                                                       {"moving_quarter", {Mode::moving, {1, true}, 2}},
                                                       {"first", {Mode::moving, {1, false}, 3, true}}};

  void figure(const std::string& name, double value, const char* unit) const {
    std::printf("%-32s %10.3f %s\n", (prefix_ + name).c_str(), value, unit);
    std::fflush(stdout);
  }

  /// What history, filter and composition add. After all others, whose history it uses.
  double withoutRays() {
    std::vector<double> rest;
    Way none = kWays.at("moving_full");
    none.rays.perPixel = 0;
    Image local, unused;
    for (int round = 0; round < 3 * options_.rounds; ++round) {
      const double base = stage_.trace(last(), kLocal, local).wall;
      rest.push_back((stage_.trace(last(), none, unused).wall - base) / base);
    }
    return bench::median(rest);
  }

  /// The image to compare with.
  void converge() {
    Way way = kFull;
    const std::string count = std::to_string(options_.reference);
    way.more = {"ao.samples=" + count, "shadows.samples=" + count}, way.allThreads = true;
    stage_.trace(last(), way, converged_);
    hits_ = bench::hitsOf(converged_);
  }

  /// Degrees of the last frame.
  int last() const { return (options_.frames - 1) * options_.step; }

  double errorOf(const Image& image) const { return bench::psnr(image.color, converged_.color, hits_); }

  void dump(const std::string& name, const Image& image) const {
    if (options_.dump.empty()) return;
    std::vector<uint8_t> pixels(image.color.size() * 4);
    for (size_t i = 0; i < image.color.size(); ++i)
      for (size_t c = 0; c < 4; ++c)
        pixels[4 * i + c] = c == 3 ? 255 : static_cast<uint8_t>(image.color[i] >> (8 * c));
    bench::writePng(bench::imageFromGl(image.width, image.height, pixels),
                    options_.dump + "_" + prefix_ + name + ".png");
  }

  const Options& options_;
  bench::Stage& stage_;
  std::string prefix_;
  double local_ = 0;
  Image converged_;
  std::vector<uint8_t> hits_;
};

void print(const bench::ComparedRays& rays, const char* kind) {
  const std::string name = std::string(kind) + "_rays";
  std::printf("%-32s %10.3f Mray/s\n", ("bare_" + name).c_str(), rays.bare * 1e-6);
  std::printf("%-32s %10.3f Mray/s\n", ("our_" + name).c_str(), rays.ours * 1e-6);
  std::printf("%-32s %10.3f of the bare loop\n", (name + "_ratio").c_str(), rays.ours / rays.bare);
}

/// The settings of a shipped preset. Throws std::runtime_error where there is none of that name.
std::vector<std::string> settingsOf(const std::string& preset) {
  const std::vector<Preset> all = allPresets({});
  const Preset* found = findPreset(preset, all);
  if (!found) throw std::runtime_error("preset: " + whyNoPreset(preset, all));
  std::vector<std::string> settings;
  for (const PresetValue& value : found->values) settings.push_back(value.name + "=" + value.value);
  return settings;
}

/// Throws std::runtime_error where `size` is not WIDTHxHEIGHT.
void readSize(const std::string& size, bench::StageOptions& stage) {
  int end = 0;
  if (std::sscanf(size.c_str(), "%dx%d%n", &stage.width, &stage.height, &end) != 2 ||
      static_cast<size_t>(end) != size.size() || std::min(stage.width, stage.height) < 16 ||
      std::max(stage.width, stage.height) > 16384)
    throw std::runtime_error("--size: not WIDTHxHEIGHT: " + size);
}

void run(Options options) {
  if (!options.size.empty()) readSize(options.size, options.stage);
  if (!options.preset.empty()) {
    const std::vector<std::string> look = settingsOf(options.preset);
    options.settings.insert(options.settings.begin(), look.begin(), look.end());
  }
  if (options.quick)
    options.frames = std::min(options.frames, 12), options.rounds = 3,
    options.reference = std::min(options.reference, 256);
  if (options.settings.empty()) options.settings = {"ao=on"};
  std::vector<std::string> shadowed = options.settings;
  shadowed.insert(shadowed.end(), options.shadows.begin(), options.shadows.end());
  bench::Stage stage(options.stage);
  std::printf("%-32s %10.3f million\n", "primitives", static_cast<double>(stage.primitives()) * 1e-6);
  const auto measure = [&](const std::vector<std::string>& settings, const char* prefix) {
    stage.use(settings);
    Measurement measurement(options, stage, prefix);
    measurement.moving();
    if (!options.noRest) measurement.atRest(), measurement.atRestSmoothed();
  };
  measure(options.settings, "");
  if (!options.shadows.empty()) measure(shadowed, "shadow_");
  // The bare loops know one size of images.
  if (options.noRays || options.stage.lines > 0 || options.stage.width > 0) return;
  stage.use(shadowed);
  print(bench::compareRays(stage, bench::RayUse::occlusion, options.stage.threads, options.rounds),
        "occlusion");
  if (!options.shadows.empty())
    print(bench::compareRays(stage, bench::RayUse::shadow, options.stage.threads, options.rounds), "shadow");
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Times and noise of frames with light, on isosurfaces of the Wavelet or on lines.");
  app.add_option("--triangles", options.stage.millionTriangles, "millions of triangles, about")
      ->check(CLI::Range(0.1, 256.0));
  app.add_option("--lines", options.stage.lines, "so many lines as tubes, instead of triangles")
      ->check(CLI::Range(1, 1000000));
  app.add_option("--threads", options.stage.threads, "0: one a core")->check(CLI::Range(0, 1024));
  app.add_option("--frames", options.frames,
                 "frames of the orbit, a degree each unless --step says otherwise")
      ->check(CLI::Range(3, 360));
  app.add_option("--step", options.step, "degrees of the orbit from frame to frame")
      ->check(CLI::Range(0, 90));
  app.add_option("--reference", options.reference, "samples of the image to compare with")
      ->check(CLI::Range(1, 4096));
  app.add_option("--set", options.settings, "NAME=VALUE: a setting (default: ao=on)");
  app.add_option("--shadow", options.shadows,
                 "NAME=VALUE: a setting of a second measurement beside the first");
  app.add_option("--preset", options.preset, "settings of a look, before those of --set");
  app.add_option("--size", options.size, "WIDTHxHEIGHT of the image (default: 1024x1024)");
  app.add_option("--only", options.only, "one way alone: first, moving_full or moving_quarter");
  app.add_flag("--quick", options.quick, "fewer frames, a noisier reference");
  app.add_flag("--no-rays", options.noRays, "leave the bare loops out");
  app.add_flag("--no-rest", options.noRest, "leave images at rest out");
  app.add_option("--dump", options.dump, "write images: the beginning of their names");
  CLI11_PARSE(app, argc, argv);
  try {
    run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gluray-bench-light: %s\n", error.what());
    return 1;
  }
  return 0;
}
