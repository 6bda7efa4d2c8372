#include "control/scene/scene_options.h"

#include "command_line.h"

#include <CLI/CLI.hpp>

namespace gluray::launcher {
namespace {

constexpr int kMaxImages = 1000000;

void describeMaterial(CLI::App& app, ControlOptions& options) {
  app.description(
      "Changes the materials and the ray visibility of individual objects (setting material.objects). Other\n"
      "values do not change, but a new material drops the values of the old one. `gluray undo` undoes the\n"
      "change. Without a material or an option, prints the entries.");
  app.add_option(
      "WORD", options.words,
      "OBJECT... [MATERIAL] [KEY=VALUE...]: numbers of `gluray objects`, ranges such as 3-7, or all;\n"
      "a word of the setting material; values such as roughness=0.1");
  auto* hide = app.add_flag("--hide", options.hide, "Hide the objects from all rays");
  auto* from = app.add_option("--hide-from", options.hideFrom,
                              "Hide them from some rays: camera, shadow, occlusion, reflection, joined by +");
  from->type_name("RAYS")->excludes(hide);
  auto* show = app.add_flag("--show", options.show, "Show the objects to all rays again");
  show->excludes(hide)->excludes(from);
  app.add_flag("--reset", options.reset, "Remove the entries of the objects")
      ->excludes(hide)
      ->excludes(from)
      ->excludes(show);
}

void describeFilm(CLI::App& app, ControlOptions& options) {
  app.description(
      "Saves the next frames in the window of a running program as numbered images. Each image is of a "
      "later\n"
      "frame than the previous one. Overwrites only PNG files. Ctrl+C ends the film and keeps all images.");
  app.add_option("FILE", options.file, "Name of the images, such as film-%04d.png, or film.png")->required();
  app.add_option("--frames", options.film.frames, "End after N images")
      ->check(CLI::Range(1, kMaxImages))
      ->type_name("N");
  app.add_option("--seconds", options.seconds, "End after S seconds")
      ->check(CLI::Range(0.001, 1e6))
      ->type_name("S");
  app.add_option("--set", options.film.ramps,
                 "Vary a setting from image to image, and restore it at the end. May be given several times")
      ->allow_extra_args(false)
      ->type_name("NAME=FROM..TO");
  app.add_option("--passes", options.film.passes,
                 "Wait until each image has been refined N times or is finished, for 60 s at most")
      ->check(CLI::Range(1, 65536))
      ->type_name("N");
}

}  // namespace

void describeSceneCommand(CLI::App& app, CommandLine& line) {
  ControlOptions& options = line.control;
  switch (line.command) {
    case Command::objects:
      app.description(
          "Lists the traced objects of running programs: number, view, shape, triangles, color, material, "
          "and\n"
          "the rays that they are hidden from.");
      break;
    case Command::pick:
      app.description("Prints the object at a point of a program's window.");
      app.add_option("POINT", options.words,
                     "X Y: pixels from the top left of the image, or percent: 50% 50%")
          ->required();
      break;
    case Command::material: describeMaterial(app, options); break;
    case Command::light:
      app.description(
          "Lists the lights of running programs, or changes settings of the group lights. `gluray light at X "
          "Y`\n"
          "moves the key light's highlight to this point; X and Y as for gluray pick.");
      app.add_option("WORD", options.words, "NAME=VALUE..., such as azimuth=30 or rig=sun; or: at X Y");
      break;
    case Command::camera:
      app.description(
          "Lists the cameras of running programs, or changes settings of the group camera. `gluray camera "
          "focus\n"
          "X Y` focuses on the surface at this point; X and Y as for gluray pick.");
      app.add_option("WORD", options.words,
                     "NAME=VALUE..., such as aperture=0.1 or f-number=2.8; or: focus X Y");
      break;
    case Command::film: describeFilm(app, options); break;
    default: break;
  }
}

}  // namespace gluray::launcher
