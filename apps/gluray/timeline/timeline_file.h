// Reads files that `--timeline` has written.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace gluray::launcher {

struct Timeline {
  struct Span {
    size_t track = 0, name = 0;  // indices into tracks and names
    double start = 0, end = 0;   // milliseconds since the beginning
    uint64_t amount = 0;         // triangles, tiles ...; 0: not recorded
    int depth = 0;               // number of the same thread's spans that enclose it
  };
  struct Track {
    int64_t thread = 0;
    std::string name;
  };
  std::vector<Track> tracks;  // the program's own thread first
  std::vector<std::string> names;
  std::vector<Span> spans;     // by start; enclosing spans first
  std::vector<double> frames;  // end of each frame, milliseconds
  double start = 0, end = 0;
};

/// Reads a timeline file, complete or truncated. Throws std::runtime_error with one line if it is none.
Timeline readTimeline(const std::string& file);

}  // namespace gluray::launcher
