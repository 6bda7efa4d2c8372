// The results of trials (gl/trials/precedents.h) of this process, kept between runs of the program in
// gluray/trials/PROGRAM.json in $XDG_CACHE_HOME or ~/.cache (adr/0125, setting remember-engine). A file that
// cannot be read or written costs only trials: that is logged at level debug. Any thread.
#pragma once
#include "gl/trials/precedents.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace gluray::intercept {

/// What decides how long frames take, besides their load.
struct Engines {
  std::string renderer;  // GL_RENDERER of the real OpenGL
  int threads = 1;       // that trace
  bool operator==(const Engines&) const = default;
};

/// The precedents of these engines in this process. The first call reads the file, unless the setting
/// remember-engine is off; then the process's end writes it if there are new results.
std::shared_ptr<gl::Precedents> precedentsOf(const Engines& engines);

// --- The file's content
struct KeptPrecedents {
  Engines engines;
  int64_t day = 0;  // of the last result, since 1970
  std::vector<gl::Precedent> list;
};
/// Days that results are valid.
constexpr int64_t kDaysKept = 30;
/// Maximum number of engines in a file.
constexpr size_t kMostEngines = 8;

/// Reads a file's content; leaves out what is older than kDaysKept at `today`. Throws std::exception if the
/// text is not such a file.
std::vector<KeptPrecedents> readPrecedents(std::string_view text, int64_t today);
/// The text of a file with the kMostEngines newest.
std::string writtenPrecedents(std::vector<KeptPrecedents> kept);

}  // namespace gluray::intercept
