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
  int turntable = 0;   // pictures of a turn of the camera around the scene; 0: one, of the saved view
  bool again = false;  // begins anew, whatever an interrupted run has left

  /// Whether more is asked for than the window's own pixels.
  bool anything() const { return !size.empty() || background != "as-shown" || !overlays; }
};

/// Adds --size, --fit, --background and --no-overlays.
void addPictureOptions(CLI::App& app, PictureOptions& options);
/// Adds --restart.
void addRestartOption(CLI::App& app, PictureOptions& options);

/// Whether the ending of the file's name is that of another program's form: .glb, .obj, .ply.
bool isOtherForm(const std::string& file);

/// Reads "WIDTHxHEIGHT". Empty, or one line that says what is wrong.
std::string readSize(const std::string& text, int& width, int& height);

}  // namespace gluray::launcher
