// Which libraries a program loads, the libraries of libraries included, and through which it reaches OpenGL.
#pragma once
#include "programs/elf_file.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace gluray::launcher {

/// Where the loader finds each library: name -> path, empty where it finds none.
using LibraryPaths = std::map<std::string, std::string>;

/// From what the loader lists ("name => path (address)" or "name => not found" a line).
LibraryPaths pathsOf(const std::string& loaderList);

struct WalkedLibrary {
  std::string name, path;  // path empty: not found
  std::string neededBy;    // name of the file that asked for it first; the program's file name at the root
};

/// Every library that `file` and its libraries need, nearest first. `read` gives what is known of a file.
std::vector<WalkedLibrary> walkLibraries(const std::string& file, const LibraryPaths& paths,
                                         const std::function<ElfFile(const std::string&)>& read);

/// "osgviewer > libosgViewer.so.161 > libGL.so.1".
std::string chainTo(const std::string& name, const std::vector<WalkedLibrary>& walk);

}  // namespace gluray::launcher
