// The measurements of a benchmark program, and the line of JSON that it prints.
#pragma once
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace gluray::bench {

struct Measurement {
  std::string program, path, renderer;
  size_t triangles = 0;
  double firstImageSeconds = 0;  // from the first use of the geometry to the first finished frame
  std::vector<double> frameSeconds;
  std::vector<double> allSeconds;  // of all frames from the first on; empty: not told
  double cpuSeconds = 0;           // of all threads of the process, a frame; 0: not told
  double buildSeconds = 0;         // of an acceleration structure, where the program builds one itself
  size_t ownBytes = 0;  // resident before the geometry was handed over: the program's own, its mesh included
};

/// The middle value; the mean of the middle two of an even number; 0 of none.
double median(std::vector<double> values);

/// First and third quartile, between two values where they fall there; zeros of none.
std::pair<double, double> quartiles(std::vector<double> values);

/// Resident memory of this process in bytes: now, of it what no file holds, and the highest since the start
/// or forgetHighest(). Zeros where /proc is not mounted.
struct ResidentBytes {
  size_t now = 0, anonymous = 0, highest = 0;
};
ResidentBytes residentBytes();
/// Resets `highest`, if the system allows it.
void forgetHighest();

/// One line of JSON: program, path, renderer, triangles, first_image_s, frame_s (median), frame_low_s and
/// frame_high_s (quartiles), frames, build_s, rss_bytes, rss_anon_bytes, peak_bytes, own_bytes; all_s and
/// cpu_s where there are any.
std::string jsonLine(const Measurement& measurement, const ResidentBytes& resident);

}  // namespace gluray::bench
