#include "programs/library_walk.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

namespace gluray::launcher {

LibraryPaths pathsOf(const std::string& loaderList) {
  LibraryPaths paths;
  std::istringstream lines(loaderList);
  for (std::string line; std::getline(lines, line);) {
    std::string name, arrow, path;
    std::istringstream(line) >> name >> arrow >> path;
    if (arrow == "=>") paths[name] = path.starts_with("/") ? path : "";
  }
  return paths;
}

std::vector<WalkedLibrary> walkLibraries(const std::string& file, const LibraryPaths& paths,
                                         const std::function<ElfFile(const std::string&)>& read) {
  std::vector<WalkedLibrary> walk;
  std::set<std::string> seen;
  const auto visit = [&](const std::string& path, const std::string& name) {
    for (const std::string& needed : read(path).needed) {
      if (!seen.insert(needed).second) continue;
      const auto found = paths.find(needed);
      // The only needed library that the loader does not list by name is itself.
      if (found != paths.end()) walk.push_back({needed, found->second, name});
    }
  };
  visit(file, std::filesystem::path(file).filename());
  for (size_t i = 0; i < walk.size(); ++i) {  // grows meanwhile
    const WalkedLibrary library = walk[i];
    if (!library.path.empty()) visit(library.path, library.name);
  }
  return walk;
}

std::string chainTo(const std::string& name, const std::vector<WalkedLibrary>& walk) {
  std::string chain = name;
  for (std::string at = name;;) {
    const auto found =
        std::find_if(walk.begin(), walk.end(), [&](const WalkedLibrary& l) { return l.name == at; });
    if (found == walk.end()) return chain;
    at = found->neededBy;
    chain = at + " > " + chain;
  }
}

}  // namespace gluray::launcher
