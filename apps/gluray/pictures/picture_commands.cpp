#include "pictures/picture_commands.h"

#include "settings/setting_options.h"

#include <CLI/CLI.hpp>

namespace gluray::launcher {

void describeRender(CLI::App& app, CommandLine& line) {
  app.description(
      "Renders a picture of a saved scene in any size, with the program's settings or with others. After an\n"
      "interruption, the same command continues. Overwrites only pictures.");
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
      "Shows a saved scene in a window, in which you can turn it, choose a look and save pictures. For each\n"
      "picture it prints the command that repeats it.");
  app.name("gluray view");
  app.add_option("SCENE", line.picture.scene, "The scene, a file that ends in .gluray")->required();
  addSettingOptions(app, line.settings, false);
}

void describeExport(CLI::App& app, CommandLine& line) {
  app.description("Converts a saved scene to a format of other programs: glTF 2.0, OBJ or PLY.");
  app.name("gluray export");
  app.add_option("SCENE", line.picture.scene, "The scene, a file that ends in .gluray")->required();
  app.add_option("FILE", line.picture.file, "Name of the new file, ending in .glb, .obj or .ply")->required();
  app.add_flag("--json", line.json, "Print JSON");
}

}  // namespace gluray::launcher
