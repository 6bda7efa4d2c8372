#include "pictures/files/band_file.h"

#include "base/printable.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <system_error>

namespace gluray::launcher {
namespace {

struct Head {
  std::array<char, 16> magic = {'G', 'L', 'u', 'R', 'a', 'y', ' ',  'b',
                                'a', 'n', 'd', 's', ' ', '2', '\n', 0};
  BandPlan plan;
  int finished = 0;
};
constexpr off_t kPixels = 4096;  // where they begin

bool readHead(int descriptor, Head& head) {
  return ::pread(descriptor, &head, sizeof head, 0) == static_cast<ssize_t>(sizeof head) &&
         head.magic == Head().magic;
}

bool writeAll(int descriptor, const void* bytes, size_t count, off_t at) {
  const auto* from = static_cast<const char*>(bytes);
  while (count > 0) {
    const ssize_t done = ::pwrite(descriptor, from, count, at);
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return false;
    from += done, at += done, count -= static_cast<size_t>(done);
  }
  return true;
}

off_t rowAt(const BandPlan& plan, int y) { return kPixels + off_t{plan.pixelBytes} * plan.width * y; }

/// The head of the file if it is one of this work.
std::optional<Head> headOf(const std::string& path, uint64_t low, uint64_t high) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
  if (descriptor < 0) return std::nullopt;
  Head head;
  const bool same = readHead(descriptor, head) && head.plan.low == low && head.plan.high == high;
  ::close(descriptor);
  return same ? std::optional(head) : std::nullopt;
}

}  // namespace

int BandFile::finishedBands(const std::string& path, uint64_t low, uint64_t high) {
  const auto head = headOf(path, low, high);
  return head ? head->finished : 0;
}

bool BandFile::isOf(const std::string& path, uint64_t low, uint64_t high) {
  return headOf(path, low, high).has_value();
}

BandFile::BandFile(std::string path, const BandPlan& plan) : path_(std::move(path)), plan_(plan) {
  descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (descriptor_ < 0) fail(errno);
  Head head;
  const bool same = readHead(descriptor_, head) && head.plan == plan_;
  if (same) return;
  head = {}, head.plan = plan_;
  if (::ftruncate(descriptor_, 0) != 0 || !writeAll(descriptor_, &head, sizeof head, 0)) fail(errno);
}

BandFile::~BandFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void BandFile::fail(int error) const {
  throw std::runtime_error(printable(path_) +
                           " cannot be written: " + std::generic_category().message(error));
}

void BandFile::add(int band, int rows, const void* pixels) {
  const size_t bytes = rowBytes() * static_cast<size_t>(rows);
  const int finished = band + 1;
  if (!writeAll(descriptor_, pixels, bytes, rowAt(plan_, band * plan_.bandRows)) ||
      !writeAll(descriptor_, &finished, sizeof finished, offsetof(Head, finished)))
    fail(errno);
}

void BandFile::row(int y, void* pixels) const {
  if (::pread(descriptor_, pixels, rowBytes(), rowAt(plan_, y)) != static_cast<ssize_t>(rowBytes()))
    throw std::runtime_error(printable(path_) + " has been changed: start again");
}

void BandFile::remove() { ::unlink(path_.c_str()); }

}  // namespace gluray::launcher
