// What can be known of a program before it is started.
#pragma once
#include "programs/elf_file.h"

#include <string>

namespace gluray::launcher {

struct Program {
  std::string path;  // empty: not found
  int error = 0;     // errno of the search where it was not found or cannot be executed
  bool setUid =
      false;  // set-uid or set-gid for somebody else: the loader ignores LD_LIBRARY_PATH and LD_PRELOAD
  bool osMesa = false;      // links libOSMesa
  bool bundledGl = false;   // links a libGL that is not libglvnd's
  bool usesX = false;       // links libX11 or libGL
  ElfFile elf;              // what its file says
  std::string libraries;    // what the loader lists, one a line
  std::string interpreter;  // of a script: the file that its first line names
};

/// Looks `name` up as execvp does and asks the loader what it links.
Program inspect(const std::string& name);

/// What the loader lists for a program or library, as ldd does; nothing of it runs.
std::string listLibraries(const std::string& path);

/// Fills in from what the loader lists for a program (one "name => path (address)" a line).
void readLibraryList(const std::string& list, Program& program);

}  // namespace gluray::launcher
