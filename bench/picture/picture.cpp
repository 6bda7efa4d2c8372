// gluray-bench-picture: images for the demo: grabs a program's window, puts images side by side, closes
// the window.
#include "bench/picture/x_window.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <thread>

namespace {

using namespace gluray::bench;

bool isPlain(const RgbImage& image) {
  const auto& rgb = image.rgb;
  return std::equal(rgb.begin() + 3, rgb.end(), rgb.begin());
}

/// The window's image once it shows something and has stayed the same for a second; throws after `patience`
/// seconds.
RgbImage steadyImage(XWindow& window, double patience) {
  constexpr int kSteadyLooks = 4;
  constexpr std::chrono::milliseconds kBetweenLooks{250};
  RgbImage last;
  int same = 0;
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(patience);
  while (std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(kBetweenLooks);
    std::optional<RgbImage> now = window.grab();
    if (!now || now->rgb.empty() || isPlain(*now)) continue;
    same = now->rgb == last.rgb ? same + 1 : 0;
    if (same == kSteadyLooks) return *now;
    last = std::move(*now);
  }
  throw std::runtime_error("no steady image in the window within the time given");
}

}  // namespace

int main(int argc, char** argv) {
  std::string name, out;
  std::vector<std::string> files;
  double patience = 120;
  CLI::App app("Grabs a program's window, closes it, or puts images side by side.");
  app.require_subcommand(1);
  auto* grab = app.add_subcommand("grab", "waits until the window shows a steady image and writes it");
  grab->add_option("--class", name, "class or instance name of the window")->required();
  grab->add_option("--out", out, "PNG file to write")->required();
  grab->add_option("--patience", patience, "seconds to wait at most");
  auto* close = app.add_subcommand("close", "asks the window to close");
  close->add_option("--class", name, "class or instance name of the window")->required();
  auto* beside = app.add_subcommand("beside", "puts images side by side");
  beside->add_option("files", files, "PNG files, from left to right")->required();
  beside->add_option("--out", out, "PNG file to write")->required();
  CLI11_PARSE(app, argc, argv);
  try {
    if (*grab) {
      XWindow window(name);
      writePng(steadyImage(window, patience), out);
    } else if (*close) {
      if (!XWindow(name).close()) throw std::runtime_error("no window of class " + name);
    } else {
      std::vector<RgbImage> images;
      for (const std::string& file : files) images.push_back(readPng(file));
      writePng(sideBySide(images, 8), out);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gluray-bench-picture: %s\n", error.what());
    return 1;
  }
  return 0;
}
