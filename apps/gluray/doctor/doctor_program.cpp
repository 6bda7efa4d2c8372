#include "doctor/doctor_program.h"

#include "doctor/host.h"
#include "programs/doors.h"
#include "programs/library_walk.h"
#include "programs/program.h"

#include <elf.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>

namespace gluray::launcher {
namespace {

const std::string kTopic = "program";

bool isOpenGl(const std::string& name) {
  const auto is = [&](const char* start) { return name.starts_with(start); };
  return is("libGL.so") || is("libOpenGL.so") || is("libGLX.so") || is("libEGL.so") || is("libOSMesa.so");
}

/// Libraries of OpenGL and the C library name each other: no hint about the program.
bool belongsToSystem(const std::string& name) {
  const auto is = [&](const char* start) { return name.starts_with(start); };
  return isOpenGl(name) || is("libGLdispatch") || is("libGLES") || is("libc.so") || is("ld-linux");
}

/// "libSDL2-2.0.so.0 names libGL.so": OpenGL libraries in a file's strings, which it may open at run time.
std::string hints(const Program& program, const std::vector<WalkedLibrary>& walk) {
  const std::vector<std::string> names = {"libGL.so", "libEGL.so", "libOSMesa.so", "libOpenGL.so"};
  std::string text;
  const auto ask = [&](const std::string& path, const std::string& name) {
    for (const std::string& found : stringsIn(path, names))
      text += (text.empty() ? "" : ", ") + name + " names " + found;
  };
  ask(program.path, "the program");
  for (const WalkedLibrary& library : walk)
    if (!library.path.empty() && !belongsToSystem(library.name)) ask(library.path, library.name);
  return text;
}

/// The chains of libraries through which the program links OpenGL.
std::string links(const std::vector<WalkedLibrary>& walk) {
  std::string text;
  for (const WalkedLibrary& library : walk) {
    const bool first = isOpenGl(library.name) && !isOpenGl(library.neededBy);
    if (first) text += (text.empty() ? "" : "; ") + chainTo(library.name, walk);
  }
  return text;
}

void reportMissing(const std::vector<WalkedLibrary>& walk, Diagnosis& diagnosis) {
  for (const WalkedLibrary& library : walk)
    if (library.path.empty())
      diagnosis.broken(kTopic, "library " + library.name + " is missing; " + library.neededBy + " needs it",
                       adviceForLibrary(library.name, thisHost()));
}

void reportDoor(const CommandLine& line, const Program& program, Diagnosis& diagnosis) {
  if (line.door != "auto") return diagnosis.ok("door", line.door + ", chosen by --door");
  if (program.osMesa)
    diagnosis.ok("door", "preload and vendor: the program links OSMesa, which libglvnd does not serve");
  else if (program.bundledGl)
    diagnosis.ok("door", "preload and vendor: the program's libGL is not libglvnd's");
  else
    diagnosis.ok("door", "vendor: libglvnd leads all of the program's OpenGL calls through GLuRay");
}

void reportWay(const Program& program, const std::vector<WalkedLibrary>& walk, Diagnosis& diagnosis) {
  const std::string linked = links(walk);
  if (!linked.empty()) return diagnosis.ok(kTopic, program.path + " links OpenGL: " + linked);
  const std::string hint = hints(program, walk);
  if (!hint.empty())
    return diagnosis.ok(kTopic, program.path + " links no OpenGL; it may open it at run time (" + hint + ")");
  diagnosis.limited(
      kTopic, program.path +
                  " neither links nor names OpenGL. It may still open it at run time, or start programs "
                  "that use it: gluray explain shows whether it does");
}

/// VTK's own passes of light keep its surfaces from being traced.
void reportLight(const std::vector<WalkedLibrary>& walk, Diagnosis& diagnosis) {
  const auto isVtk = [](const WalkedLibrary& library) {
    return library.name.starts_with("libvtkRenderingOpenGL2");
  };
  if (!std::any_of(walk.begin(), walk.end(), isVtk)) return;
  diagnosis.ok("light",
               "it draws with VTK. To get GLuRay's light, switch VTK's own off in the program: screen-space "
               "ambient occlusion and shadow maps keep surfaces from being traced; gluray explain shows "
               "whether it uses them");
}

/// Examines a script by its interpreter.
void examineScript(const CommandLine& line, const Program& program, Diagnosis& diagnosis) {
  CommandLine deeper = line;
  deeper.program = {program.interpreter};
  diagnosis.ok(kTopic, program.path + " is a script for " + program.interpreter +
                           "; GLuRay also traces the programs that it starts");
  if (inspect(program.interpreter).path.empty())
    diagnosis.broken(kTopic, "the interpreter " + program.interpreter + " was not found");
  else
    reportDoor(line, inspect(program.interpreter), diagnosis);
}

bool hasDisplay() { return std::getenv("DISPLAY") || std::getenv("WAYLAND_DISPLAY"); }

void examineBinary(const CommandLine& line, const Program& program, Diagnosis& diagnosis) {
  if (!program.elf.is64 || program.elf.machine != readElf(launcherFile()).machine)
    return diagnosis.broken(kTopic,
                            program.path + " is a 32-bit program, or for another processor than GLuRay");
  if (program.elf.interpreter.empty())
    return diagnosis.broken(kTopic,
                            program.path + " is linked statically: GLuRay cannot see its OpenGL calls",
                            "link it with the system's libGL or libOpenGL");
  const auto walk = walkLibraries(program.path, pathsOf(program.libraries), readElf);
  reportMissing(walk, diagnosis);
  reportWay(program, walk, diagnosis);
  reportLight(walk, diagnosis);
  if (program.usesX && !hasDisplay())
    diagnosis.broken(kTopic, "it links X11, and there is no display",
                     "xvfb-run -s '-screen 0 1280x1024x24' gluray " + line.program[0]);
  reportDoor(line, program, diagnosis);
}

}  // namespace

void examineProgram(const CommandLine& line, Diagnosis& diagnosis) {
  const Program program = inspect(line.program[0]);
  if (program.path.empty())
    return diagnosis.broken(
        kTopic, line.program[0] + (program.error == ENOENT ? " was not found" : " cannot be executed"));
  if (!program.privilege.empty()) return diagnosis.broken(kTopic, program.whyUnseen());
  if (!program.interpreter.empty()) return examineScript(line, program, diagnosis);
  if (!program.elf.elf)
    return diagnosis.limited(kTopic,
                             program.path + " is no ELF file and names no interpreter; /bin/sh will run it");
  examineBinary(line, program, diagnosis);
}

}  // namespace gluray::launcher
