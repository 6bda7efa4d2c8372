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
  app.add_option("--size", options.size, "Size of the picture in pixels [the size of the window]")
      ->type_name("WIDTHxHEIGHT");
  app.add_option(
         "--fit", options.fit,
         "If the aspect ratio of the picture differs from that of the window: all shows more at two sides,\n"
         "crop cuts two sides off, stretch distorts the view")
      ->check(CLI::IsMember({"all", "crop", "stretch"}))
      ->capture_default_str();
  app.add_option("--background", options.background,
                 "Keep the background of the window (as-shown) or remove it (transparent)")
      ->check(CLI::IsMember({"as-shown", "transparent"}))
      ->capture_default_str();
  app.add_option("--depth", options.depth,
                 "Bits per channel: 8 or 16 for PNG [8], 16 or 32 for the colours of OpenEXR [32]")
      ->check(CLI::IsMember({8, 16, 32}))
      ->type_name("BITS");
  app.add_option(
         "--layers", options.layers,
         "Additional layers of an OpenEXR file: all, or a comma-separated list of albedo, normal, position,\n"
         "depth, object and material")
      ->type_name("NAMES");
  app.add_flag("!--no-overlays", options.overlays,
               "Omit overlays: text, axes and widgets that the program draws over surfaces");
}

void addRestartOption(CLI::App& app, PictureOptions& options) {
  app.add_flag("--restart", options.again, "Start from the beginning, even if a picture was interrupted");
}

void addFilmOptions(CLI::App& app, PictureOptions& options) {
  auto* const turntable = app.add_option(
      "--turntable", options.turntable,
      "Make N numbered pictures of one turn of the camera around the scene, without overlays. FILE is a\n"
      "pattern such as turn-%04d.png");
  turntable->check(CLI::Range(1, 100000))->type_name("N");
  auto* const path = app.add_option(
      "--path", options.path,
      "Make numbered pictures along the camera path in FILE, without overlays: JSON, or ParaView's .pvcc\n"
      "(may be given several times) or .pvsm");
  path->allow_extra_args(false)->excludes(turntable)->type_name("FILE");
  app.add_option("--frames", options.frames,
                 "Make N pictures along the path [the number in FILE, or one for each camera]")
      ->check(CLI::Range(1, 100000))
      ->needs(path)
      ->type_name("N");
  app.add_option("--saved-camera", options.savedCamera,
                 "File with the camera of the saved view, .pvcc or JSON [one of the path's cameras]")
      ->needs(path)
      ->type_name("FILE");
  auto* const video = app.add_flag(
      "--y4m", options.video,
      "Write the film to standard output for an encoder; FILE is -. Example: gluray render ... - --y4m |\n"
      "ffmpeg -i - film.mp4");
  app.add_option("--fps", options.fps, "Frames per second of the stream")
      ->needs(video)
      ->type_name("N")
      ->capture_default_str();
}

void addRepeatOption(CLI::App& app, PictureOptions& options, const std::vector<std::string>& needed) {
  app.add_option(
         "--again", options.repeat,
         "Repeat the command that made PICTURE (.png), if the scene is unchanged. Allows no other options")
      ->type_name("PICTURE");
  app.callback([&app, &options, needed] {
    for (const CLI::Option* option : app.get_options()) {
      const std::string name = option->get_name();
      const bool along = name == "--again" || name == "--json" || name == "-p" || name == "--help,-h";
      if (!options.repeat.empty() && option->count() > 0 && !along) throw CLI::ExcludesError("--again", name);
    }
    for (const std::string& name : needed)
      if (options.repeat.empty() && app.get_option(name)->count() == 0) throw CLI::RequiredError(name);
  });
}

}  // namespace gluray::launcher
