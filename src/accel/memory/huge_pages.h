// Turns off huge pages, which Embree asks for, where they are slow. Virtual machines that return free memory
// to their host (virtio balloon with free page reporting) fetch each huge page from the host at first touch,
// at about 0.5 GB/s; small pages mostly come from memory still present, at 1 to 3 GB/s. This dominates the
// first image of large geometry; tracing is as fast with small pages. Any thread.
#pragma once
#include <cstdint>
#include <string_view>

namespace gluray::accel {

/// Whether a virtio device is a balloon that reports free pages, by its entries `device` ("0x0005") and
/// `features` ("011001...", bit 0 first) under /sys.
bool reportsFreePages(std::string_view device, std::string_view features);

/// During its lifetime the process allocates small pages, if `triangles` is large and the machine reports
/// free pages. The destructor restores the process's own setting.
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
