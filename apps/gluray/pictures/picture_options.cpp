#include "pictures/picture_options.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <charconv>

namespace gluray::launcher {

namespace {

constexpr int kLargestSide = 32768;

}  // namespace

std::string readSize(const std::string& text, int& width, int& height) {
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, width);
  const bool crossed =
      first.ec == std::errc() && first.ptr != end && (*first.ptr == 'x' || *first.ptr == 'X');
  const auto second = crossed ? std::from_chars(first.ptr + 1, end, height) : first;
  const bool read = crossed && second.ec == std::errc() && second.ptr == end;
  const auto inRange = [](int side) { return side >= 1 && side <= kLargestSide; };
  if (read && inRange(width) && inRange(height)) return "";
  return "--size " + text + ": use WIDTHxHEIGHT in pixels, each 1 to " + std::to_string(kLargestSide) +
         ", such as 3840x2160";
}

bool isOtherForm(const std::string& file) {
  constexpr std::array<const char*, 3> kEndings = {".glb", ".obj", ".ply"};
  return std::any_of(kEndings.begin(), kEndings.end(), [&](const std::string& ending) {
    return file.size() > ending.size() && file.ends_with(ending);
  });
}

std::string whyNotOf(const PictureOptions& options) {
  const int depth = options.depth;
  if (!options.layers.empty() && !options.isExr())
    return "--layers: PNG files have no layers; use a name that ends in .exr";
  if (options.isExr()) return depth == 8 ? "--depth 8: OpenEXR files have 16 or 32 bits a channel" : "";
  return depth == 32 ? "--depth 32: PNG files have 8 or 16 bits a channel; use a name that ends in .exr" : "";
}

void addPictureOptions(CLI::App& app, PictureOptions& options) {
  app.add_option("--size", options.size, "Pixels of the picture [those of the window]")
      ->type_name("WIDTHxHEIGHT");
  app.add_option(
         "--fit", options.fit,
         "If the picture has another aspect ratio than the window: all shows more at two sides, crop\n"
         "cuts two sides off, stretch distorts")
      ->check(CLI::IsMember({"all", "crop", "stretch"}))
      ->capture_default_str();
  app.add_option("--background", options.background, "The window's background, or none")
      ->check(CLI::IsMember({"as-shown", "transparent"}))
      ->capture_default_str();
  app.add_option("--depth", options.depth,
                 "Bits a channel: 8 or 16 of PNG files [8], 16 or 32 of the colours of OpenEXR files [32]")
      ->check(CLI::IsMember({8, 16, 32}))
      ->type_name("BITS");
  app.add_option(
         "--layers", options.layers,
         "Layers of an OpenEXR file beside its colours: all, or a list of albedo, normal, position, depth,\n"
         "object and material, with commas")
      ->type_name("NAMES");
  app.add_flag("!--no-overlays", options.overlays,
               "Leave out what the program draws over surfaces: text, axes, widgets");
}

void addRestartOption(CLI::App& app, PictureOptions& options) {
  app.add_flag("--restart", options.again, "Begin anew, even if a picture was interrupted");
}

}  // namespace gluray::launcher
