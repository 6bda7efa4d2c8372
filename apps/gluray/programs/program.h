// Examines a program without running it.
#pragma once
#include "programs/elf_file.h"

#include <string>

namespace gluray::launcher {

struct Program {
  std::string path;         // empty: the search found none
  int error = 0;            // then errno of the search; ENOENT: there is none. Else execvp may find one
  std::string privilege;    // "is set-uid" or the like: the loader ignores LD_LIBRARY_PATH and LD_PRELOAD;
                            // empty: it does not
  bool osMesa = false;      // links a libOSMesa that is not GLuRay's (own_osmesa.h)
  bool bundledGl = false;   // links a libGL that is not libglvnd's
  bool usesX = false;       // links libX11 or libGL
  ElfFile elf;              // its ELF headers
  std::string libraries;    // the loader's list (listLibraries), one a line
  std::string interpreter;  // of a script: the interpreter that its first line names

  /// One line: why a program with a privilege is not traced.
  std::string whyUnseen() const {
    return path + " " + privilege + ": the system does not let GLuRay see its calls";
  }
};

/// Looks `name` up as execvp does and asks the loader what it links. Where the system does not tell whether a
/// file may be executed, the first that looks executable is taken.
Program inspect(const std::string& name);

/// The libraries that the loader lists for a program or library, as ldd does; runs no code of it.
std::string listLibraries(const std::string& path);

/// Sets osMesa, bundledGl and usesX from the loader's list ("name => path (address)" a line).
void readLibraryList(const std::string& list, Program& program);

}  // namespace gluray::launcher
