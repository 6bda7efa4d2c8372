// The files that programs leave in the runtime directory (docs/control-protocol.md). Any thread.
#pragma once
#include <string>
#include <vector>

namespace gluray::control {

/// What a file says.
struct ProgramFile {
  int pid = 0;
  std::string name, display;
  unsigned long window = 0;  // 0: it shows none
};

/// Those whose process runs, and began when the file says. Removes the others. Takes regular files of this
/// user of at most 4 KiB, and no links.
std::vector<ProgramFile> programFiles(const std::string& directory);

}  // namespace gluray::control
