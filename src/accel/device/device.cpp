#include "accel/device/device.h"

#include "accel/device/embree.h"
#include "accel/device/error.h"

#include <sys/types.h>
#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

#include <atomic>
#include <string>

namespace gluray::accel {
namespace {

std::atomic<ptrdiff_t> heldBytes{0};
std::atomic<ptrdiff_t> behindBytes{0};  // sum of all changes inside a BehindScope
thread_local bool t_behind = false;
thread_local ptrdiff_t t_behindBytes = 0;
std::atomic<int> commitsToFail{0}, commitsToSpare{0};
std::atomic<int> failingCommits{0};  // commits in flight that were chosen to fail

bool onMemory(void*, ssize_t bytes, bool) {
  // Embree asks before it allocates and never frees what is refused here: do not count it.
  if (bytes > 0 && failingCommits.load(std::memory_order_relaxed) > 0) return false;
  heldBytes.fetch_add(bytes, std::memory_order_relaxed);
  if (t_behind) {
    behindBytes.fetch_add(bytes, std::memory_order_relaxed);
    t_behindBytes += bytes;
  }
  return true;
}

const char* describe(RTCError error) {
  switch (error) {
    case RTC_ERROR_NONE: return "no error";
    case RTC_ERROR_INVALID_ARGUMENT: return "invalid argument";
    case RTC_ERROR_INVALID_OPERATION: return "invalid operation";
    case RTC_ERROR_OUT_OF_MEMORY: return "out of memory";
    case RTC_ERROR_UNSUPPORTED_CPU: return "this processor lacks SSE2";
    case RTC_ERROR_CANCELLED: return "cancelled";
    default: return "unknown error in Embree";
  }
}

}  // namespace

// The cache is for subdivision surfaces, which we have none of, and takes 128 MB of address space.
Device::Device() : device_(rtcNewDevice("verbose=0,ignore_config_files=1,tessellation_cache_size=0")) {
  if (!device_) throw Error(std::string("Embree does not start: ") + describe(rtcGetDeviceError(nullptr)));
  rtcSetDeviceMemoryMonitorFunction(device_, onMemory, nullptr);
  if (rtcGetDeviceProperty(device_, RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED))
    packetWidth_ = 16;
  else if (rtcGetDeviceProperty(device_, RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED))
    packetWidth_ = 8;
}

Device::~Device() { rtcReleaseDevice(device_); }

std::string Device::version() const {
  const auto part = [&](RTCDeviceProperty name) {
    return std::to_string(rtcGetDeviceProperty(device_, name));
  };
  return part(RTC_DEVICE_PROPERTY_VERSION_MAJOR) + "." + part(RTC_DEVICE_PROPERTY_VERSION_MINOR) + "." +
         part(RTC_DEVICE_PROPERTY_VERSION_PATCH);
}

namespace {
size_t atLeastNone(ptrdiff_t bytes) { return bytes > 0 ? static_cast<size_t>(bytes) : 0; }
}  // namespace

size_t Device::bytes() { return atLeastNone(heldBytes.load(std::memory_order_relaxed)); }

ptrdiff_t Device::bytesOfFrames() {
  return heldBytes.load(std::memory_order_relaxed) - behindBytes.load(std::memory_order_relaxed);
}

HeldBytes::HeldBytes(size_t bytes) : bytes_(bytes) {
  heldBytes.fetch_add(static_cast<ptrdiff_t>(bytes_), std::memory_order_relaxed);
}
HeldBytes::~HeldBytes() { heldBytes.fetch_sub(static_cast<ptrdiff_t>(bytes_), std::memory_order_relaxed); }

BehindScope::BehindScope() { t_behind = true, t_behindBytes = 0; }
BehindScope::~BehindScope() { t_behind = false; }
size_t BehindScope::bytes() const { return atLeastNone(t_behindBytes); }

void Device::check(std::string_view what) const {
  const RTCError error = rtcGetDeviceError(device_);
  if (error == RTC_ERROR_NONE) return;
  const std::string line = std::string(what) + ": " + describe(error);
  throw Error(line, error == RTC_ERROR_OUT_OF_MEMORY ? scene::Loss::frames : scene::Loss::tracing);
}

void failNextCommits(int count, int after) { commitsToSpare = after, commitsToFail = count; }
int commitsStillToFail() { return commitsToFail; }

namespace {

/// Its lifetime spans one commit; failNextCommits() acts only inside.
class CommitScope {
 public:
  CommitScope() {
    if (commitsToSpare.load() > 0 && commitsToSpare.fetch_sub(1) > 0) return;
    if (commitsToFail.load() > 0 && commitsToFail.fetch_sub(1) > 0) ++failingCommits;
  }
  ~CommitScope() { failingCommits = 0; }
  CommitScope(const CommitScope&) = delete;
  CommitScope& operator=(const CommitScope&) = delete;
};

/// The context of the tasks that commit. Never destroyed: contexts that Embree's scenes keep have it as
/// parent.
tbb::task_group_context& commitContext() {
  static auto* const context = new tbb::task_group_context(tbb::task_group_context::isolated);
  return *context;
}

}  // namespace

// An Embree scene keeps the context of its first commit's tasks, whose parent is the context around that
// commit. To cancel any tasks, as Embree does when a commit fails, TBB visits all contexts and their parents.
// A loop's context ends with the loop.
void commitScene(RTCSceneTy* scene) {
  const auto commit = [scene](int) {
    const CommitScope scope;
    rtcCommitScene(scene);
  };
  tbb::parallel_for(0, 1, commit, tbb::simple_partitioner(), commitContext());
}

}  // namespace gluray::accel
