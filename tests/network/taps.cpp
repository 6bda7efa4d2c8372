#include "tests/network/taps.h"

#include <fcntl.h>
#include <linux/if.h>
#include <linux/if_tun.h>
#include <sched.h>
#include <sys/ioctl.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <stdexcept>

namespace network {
namespace {

int checked(int result, const std::string& what) {
  if (result < 0) throw std::runtime_error(what + ": " + std::strerror(errno));
  return result;
}

/// Enters the network namespace of a process until it goes out of scope.
class Inside {
 public:
  explicit Inside(const std::string& process) {
    const std::string theirs = "/proc/" + process + "/ns/net";
    own_ = checked(open("/proc/self/ns/net", O_RDONLY | O_CLOEXEC), "own network");
    const int there = open(theirs.c_str(), O_RDONLY | O_CLOEXEC);
    const int entered = there < 0 ? -1 : setns(there, CLONE_NEWNET);
    const int error = errno;
    if (there >= 0) close(there);
    if (entered < 0) close(own_), errno = error;
    checked(entered, theirs);
  }
  ~Inside() { setns(own_, CLONE_NEWNET), close(own_); }
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;

 private:
  int own_;
};

int tap(const std::string& name) {
  const int file = checked(open("/dev/net/tun", O_RDWR | O_NONBLOCK | O_CLOEXEC), "/dev/net/tun");
  ifreq request{};
  request.ifr_flags = IFF_TAP | IFF_NO_PI;
  std::copy_n(name.data(), std::min<size_t>(name.size(), IFNAMSIZ - 1), request.ifr_name);
  if (ioctl(file, TUNSETIFF, &request) < 0) {
    const int error = errno;
    close(file), errno = error;
    checked(-1, "TAP interface " + name);
  }
  return file;
}

}  // namespace

Taps::Taps(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const size_t colon = name.find(':');
    if (colon == std::string::npos) throw std::runtime_error("NAME:PROCESS is missing in " + name);
    const Inside inside(name.substr(colon + 1));
    files_.push_back(tap(name.substr(0, colon)));
  }
}

Taps::~Taps() {
  for (const int file : files_) close(file);
}

int64_t now() {
  return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

int waitUntil(std::vector<pollfd>& waits, int64_t time) {
  if (time < 0) return ppoll(waits.data(), waits.size(), nullptr, nullptr);
  const int64_t left = std::max<int64_t>(time - now(), 0);
  const timespec span{left / 1'000'000'000, left % 1'000'000'000};
  return ppoll(waits.data(), waits.size(), &span, nullptr);
}

}  // namespace network
