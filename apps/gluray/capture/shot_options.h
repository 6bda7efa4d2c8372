// What gluray run is asked for about pictures of the program that it starts. Pure functions; any thread.
#pragma once
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gluray::launcher {

struct ShotOptions {
  std::string file;                   // empty: no pictures are wanted
  std::string when = "idle";          // a frame's number, "12.5s", "idle", "every", "every:10"
  bool quit = false;                  // the program is ended when its picture is taken
  std::vector<std::string> settings;  // "NAME=VALUE": of the pictures alone

  bool isSequence() const { return when.starts_with("every"); }
};

/// Adds --shot, --shot-at, --shot-set and --quit.
void addShotOptions(CLI::App& app, ShotOptions& options);

/// What the engine is told of `when`: "frame:12", "every:10", "seconds:12.5", "idle". Throws
/// std::runtime_error with one line.
std::string planOf(const std::string& when);

/// The file of picture `number`, counted from 1. Throws std::runtime_error with one line if numbered names
/// are needed, or none is possible.
std::string fileOfShot(const ShotOptions& options, int number);

/// What is wrong with the options; empty: nothing.
std::string problemOf(const ShotOptions& options);

}  // namespace gluray::launcher
