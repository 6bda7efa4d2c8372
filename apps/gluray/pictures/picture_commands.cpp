#include "pictures/picture_commands.h"

#include "settings/setting_options.h"

#include <CLI/CLI.hpp>

namespace gluray::launcher {

void describeRender(CLI::App& app, CommandLine& line) {
  app.description(
      "Makes a picture of a scene that `gluray save` saved, of any size, with the settings that the program "
      "had\n"
      "or others. If it is interrupted, the same command goes on where it ended. Overwrites pictures only.");
  app.name("gluray render");
  app.add_option("SCENE", line.picture.scene, "The scene, a file that ends in .gluray");
  app.add_option("FILE", line.picture.file, "Name of the picture, ending in .png or .exr; - with --y4m");
  addPictureOptions(app, line.picture);
  addRestartOption(app, line.picture);
  addFilmOptions(app, line.picture);
  app.add_flag("--json", line.json, "Print JSON");
  addSettingOptions(app, line.settings, false);
  addRepeatOption(app, line.picture, {"SCENE", "FILE"});
}

void describeView(CLI::App& app, CommandLine& line) {
  app.description(
      "Shows a scene that `gluray save` saved in a window: to turn it, to choose a look, and to save "
      "pictures. "
      "For\n"
      "each one it prints the command that makes it again.");
  app.name("gluray view");
  app.add_option("SCENE", line.picture.scene, "The scene, a file that ends in .gluray")->required();
  addSettingOptions(app, line.settings, false);
}

void describeExport(CLI::App& app, CommandLine& line) {
  app.description(
      "Writes a scene that `gluray save` saved in a form that other programs read: glTF 2.0, OBJ or PLY.");
  app.name("gluray export");
  app.add_option("SCENE", line.picture.scene, "The scene, a file that ends in .gluray")->required();
  app.add_option("FILE", line.picture.file, "Name of the new file, ending in .glb, .obj or .ply")->required();
  app.add_flag("--json", line.json, "Print JSON");
}

}  // namespace gluray::launcher
