// gluray: runs a program with its OpenGL calls led through GLuRay, then gets out of the way (exec).
#include "command_line.h"
#include "doors.h"
#include "program.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <vector>

namespace {

constexpr int kNotFound = 127, kNotExecutable = 126;

int fail(const std::string& program, int error) {
  std::cerr << "gluray: " << program << ": " << (error == ENOENT ? "program not found" : std::strerror(error))
            << "\n";
  return error == ENOENT ? kNotFound : kNotExecutable;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace gluray::launcher;
  const Parsed parsed = parse(argc, argv);
  if (!parsed.run) return parsed.exitCode;
  const CommandLine& line = parsed.commandLine;

  const Program program = inspect(line.program[0]);
  if (program.path.empty()) return fail(line.program[0], program.error);
  if (program.usesX && !std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY"))
    std::cerr << "gluray: DISPLAY is not set; without a screen, try: xvfb-run -s '-screen 0 1280x1024x24' "
                 "gluray ...\n";
  if (const std::string why = openDoors(line, program); !why.empty())
    std::cerr << "gluray: not ray traced: " << why << "\n";

  std::vector<char*> arguments;
  for (const std::string& word : line.program) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  execv(program.path.c_str(), arguments.data());
  if (errno == ENOEXEC) {  // a script without #!: as the shell would
    arguments.insert(arguments.begin(), const_cast<char*>("/bin/sh"));
    arguments[1] = const_cast<char*>(program.path.c_str());
    execv("/bin/sh", arguments.data());
  }
  return fail(line.program[0], errno);
}
