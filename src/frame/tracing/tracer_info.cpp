#include "frame/tracing/tracer_info.h"

#include "accel/device/device.h"
#include "parallel/arena.h"
#include "render/kernels/kernels.h"

#include <tbb/version.h>

#include <exception>

namespace gluray::frame {

TracerInfo tracerInfo(int wantedThreads) noexcept {
  TracerInfo info;
  try {
    info.tbb = TBB_runtime_version();
    info.kernels = render::kernelTarget();
    info.threads = Arena(wantedThreads).threads();
    const accel::Device device;
    info.embree = device.version();
    info.rayPacket = device.packetWidth();
  } catch (const std::exception& e) { info.problem = e.what(); }
  return info;
}

}  // namespace gluray::frame
