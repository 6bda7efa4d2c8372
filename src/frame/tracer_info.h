// What the ray tracer is made of on this machine, for reports. Any thread.
#pragma once
#include <string>

namespace gluray::frame {

struct TracerInfo {
  std::string embree, tbb;  // versions of the libraries that are loaded; empty: it does not start
  std::string kernels;      // instruction set of our own loops, such as "AVX2"
  int rayPacket = 0;        // rays that Embree traces at once on this processor
  int threads = 0;          // that trace, with `wantedThreads` of the settings
  std::string problem;      // why Embree does not start
};

/// Starts and ends an Embree device. Never throws.
TracerInfo tracerInfo(int wantedThreads) noexcept;

}  // namespace gluray::frame
