#include "intercept/capture/rest_detector.h"

#include <sys/resource.h>
#include <sys/time.h>

namespace gluray::intercept {
namespace {

constexpr double kQuiet = 1.5;  // seconds
constexpr double kIdle = 0.2;   // of one core

}  // namespace

double RestDetector::processorSeconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

bool RestDetector::isAtRest(uint64_t frames, double now, double worked) {
  const bool quiet = frames > 0 && frames == frames_;
  if (quiet && now - since_ < kQuiet) return false;
  if (quiet && worked - worked_ < kIdle * (now - since_)) return true;
  frames_ = frames, since_ = now, worked_ = worked;
  return false;
}

}  // namespace gluray::intercept
