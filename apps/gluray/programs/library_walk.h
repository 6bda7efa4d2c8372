// Lists the libraries that a program loads, directly and indirectly, and the chain to one of them.
#pragma once
#include "programs/elf_file.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace gluray::launcher {

/// Where the loader finds each library: name -> path, empty where it finds none.
using LibraryPaths = std::map<std::string, std::string>;

/// Parses the loader's list ("name => path (address)" or "name => not found" a line).
LibraryPaths pathsOf(const std::string& loaderList);

struct WalkedLibrary {
  std::string name, path;  // path empty: not found
  std::string neededBy;  // name of the first file that needs it: a library's name, or the program's file name
};

/// Every library that `file` and its libraries need, breadth first. `read` reads the ELF file at a path.
std::vector<WalkedLibrary> walkLibraries(const std::string& file, const LibraryPaths& paths,
                                         const std::function<ElfFile(const std::string&)>& read);

/// "osgviewer > libosgViewer.so.161 > libGL.so.1".
std::string chainTo(const std::string& name, const std::vector<WalkedLibrary>& walk);

}  // namespace gluray::launcher
