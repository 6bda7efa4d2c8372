#include "accel/memory/huge_pages.h"

#include "base/log.h"

#include <sys/prctl.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace gluray::accel {
namespace {

std::string firstWord(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string word;
  stream >> word;
  return word;
}

bool machineReportsFreePages() noexcept {
  try {
    for (const auto& entry : std::filesystem::directory_iterator("/sys/bus/virtio/devices")) {
      if (!reportsFreePages(firstWord(entry.path() / "device"), firstWord(entry.path() / "features")))
        continue;
      log::once(log::Level::info, "huge pages",
                "this virtual machine reports free pages to its host: large acceleration structures use "
                "small memory pages");
      return true;
    }
  } catch (...) {  // no virtio here
  }
  return false;
}

}  // namespace

bool reportsFreePages(std::string_view device, std::string_view features) {
  constexpr size_t kReporting = 5;  // VIRTIO_BALLOON_F_REPORTING; Virtual I/O Device 1.2, section 5.5
  return device == "0x0005" && features.size() > kReporting && features[kReporting] == '1';
}

SmallPages::SmallPages(uint64_t triangles) noexcept {
  constexpr uint64_t kMany = 200'000;  // about 20 MB; smaller structures fit into recycled memory
  if (triangles < kMany) return;
  static const bool slow = machineReportsFreePages();
  // Huge pages are off already: nothing to do or to restore.
  if (!slow || prctl(PR_GET_THP_DISABLE, 0, 0, 0, 0) != 0) return;
  active_ = prctl(PR_SET_THP_DISABLE, 1, 0, 0, 0) == 0;
}

SmallPages::~SmallPages() {
  if (active_) prctl(PR_SET_THP_DISABLE, 0, 0, 0, 0);
}

}  // namespace gluray::accel
