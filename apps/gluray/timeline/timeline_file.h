// What `--timeline` has written, read back.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace gluray::launcher {

struct Timeline {
  struct Span {
    size_t track = 0, name = 0;  // indices into tracks and names
    double start = 0, end = 0;   // milliseconds since the beginning
    uint64_t amount = 0;         // triangles, tiles ...; 0: not told
    int depth = 0;               // spans of the same thread that it lies within
  };
  struct Track {
    int64_t thread = 0;
    std::string name;
  };
  std::vector<Track> tracks;  // the program's own thread first
  std::vector<std::string> names;
  std::vector<Span> spans;     // by start, within each other from the outside
  std::vector<double> frames;  // when they ended
  double start = 0, end = 0;
};

/// Reads a file of ours, whole or cut off. Throws std::runtime_error with one line where it is none.
Timeline readTimeline(const std::string& file);

}  // namespace gluray::launcher
