// Versions and capabilities of the ray tracer on this machine, for reports. Any thread.
#pragma once
#include <string>

namespace gluray::frame {

struct TracerInfo {
  std::string embree, tbb;  // versions of the loaded libraries; empty: Embree does not start
  std::string kernels;      // instruction set of our own loops, such as "AVX2"
  int rayPacket = 0;        // Embree's native packet width on this processor
  int threads = 0;          // tracing threads, for `wantedThreads` of the settings
  std::string problem;      // why Embree does not start
};

/// Creates and releases an Embree device. Never throws.
TracerInfo tracerInfo(int wantedThreads) noexcept;

}  // namespace gluray::frame
