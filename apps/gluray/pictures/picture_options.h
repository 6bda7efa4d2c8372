// What gluray render and gluray shot are asked for.
#pragma once
#include <string>

namespace CLI {
class App;
}

namespace gluray::launcher {

struct PictureOptions {
  std::string scene, file;
  std::string size;                     // "WIDTHxHEIGHT"; empty: as the window
  std::string fit = "all";              // all, crop, stretch
  std::string background = "as-shown";  // as-shown, transparent
  bool overlays = true;
  std::string layers;  // of OpenEXR: names and commas, or "all"
  int depth = 0;       // bits a channel; 0: 8 of PNG, 32 of OpenEXR
  int turntable = 0;   // pictures of a turn of the camera around the scene; 0: one, of the saved view
  bool again = false;  // begins anew, whatever an interrupted run has left

  /// Whether more is asked for than the window's own pixels.
  bool anything() const {
    return !size.empty() || background != "as-shown" || !overlays || depth > 8 || isExr();
  }
  /// Whether the file is an OpenEXR one, by its name.
  bool isExr() const { return file.ends_with(".exr"); }
};

/// Adds --size, --fit, --background, --depth, --layers and --no-overlays.
void addPictureOptions(CLI::App& app, PictureOptions& options);
/// Adds --restart.
void addRestartOption(CLI::App& app, PictureOptions& options);

/// Whether the ending of the file's name is that of another program's form: .glb, .obj, .ply.
bool isOtherForm(const std::string& file);

/// Whether the file can have these values. Empty, or one line that says what is wrong.
std::string whyNotOf(const PictureOptions& options);

/// Reads "WIDTHxHEIGHT". Empty, or one line that says what is wrong.
std::string readSize(const std::string& text, int& width, int& height);

}  // namespace gluray::launcher
