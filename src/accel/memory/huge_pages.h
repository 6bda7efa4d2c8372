// Embree asks for huge pages. Virtual machines that give free memory back to their host (virtio balloon with
// free page reporting) fill each huge page from the host when it is first touched, at some 0.5 GB/s, while
// small pages mostly come from memory that is still there, at 1 to 3 GB/s: there the first picture of large
// geometry waits for nothing else. Rays are as fast in small pages. Any thread.
#pragma once
#include <cstdint>
#include <string_view>

namespace gluray::accel {

/// Whether a virtio device's entries `device` ("0x0005") and `features` ("011001...", bit 0 first) under /sys
/// describe a balloon that reports free pages.
bool reportsFreePages(std::string_view device, std::string_view features);

/// While it lives, memory that the process asks for comes in small pages, if `triangles` are many and the
/// machine reports free pages. The process's own wish is put back at the end.
class SmallPages {
 public:
  explicit SmallPages(uint64_t triangles) noexcept;
  ~SmallPages();
  SmallPages(const SmallPages&) = delete;
  SmallPages& operator=(const SmallPages&) = delete;

 private:
  bool active_ = false;
};

}  // namespace gluray::accel
