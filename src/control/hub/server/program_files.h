// The files that programs leave in the runtime directory (docs/control-protocol.md). Any thread.
#pragma once
#include <string>
#include <vector>

namespace gluray::control {

/// Contents of a program's file.
struct ProgramFile {
  int pid = 0;
  std::string name, display;
  unsigned long window = 0;  // 0: it shows no window
};

/// The files whose process runs and began at the time in the file. Removes all others. Reads only regular
/// files of this user of at most 4 KiB, and no links.
std::vector<ProgramFile> programFiles(const std::string& directory);

}  // namespace gluray::control
