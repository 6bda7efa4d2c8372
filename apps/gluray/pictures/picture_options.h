// What gluray render and gluray shot are asked for.
#pragma once
#include <string>
#include <vector>

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
  std::vector<std::string> path;  // files with cameras, in place of a turn
  std::string savedCamera;        // a file with the saved view's; empty: it is in the path
  int frames = 0;                 // pictures of the path; 0: as its files say
  bool video = false;             // a stream on standard output, in place of files
  std::string fps = "25";         // of the stream
  std::string repeat;             // the picture whose command is to be repeated; empty: none
  // Of the scene and the cameras of the picture that is repeated; empty: any.
  std::string sceneHash, camerasHash;
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

/// Adds --turntable, --path and what belongs to them, and --y4m.
void addFilmOptions(CLI::App& app, PictureOptions& options);

/// Adds --again. `needed`: what else must be given; with --again nothing of it may be. Call it last.
void addRepeatOption(CLI::App& app, PictureOptions& options, const std::vector<std::string>& needed);

/// Reads "WIDTHxHEIGHT". Empty, or one line that says what is wrong.
std::string readSize(const std::string& text, int& width, int& height);

}  // namespace gluray::launcher
