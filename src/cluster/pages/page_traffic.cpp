#include "cluster/pages/page_traffic.h"

#include <array>
#include <cstdio>

namespace gluray::cluster {
namespace {

constexpr uint64_t kOverAndOver = 3;  // times that the average page comes in one image
constexpr uint64_t kStructure = 3;    // bytes of a page's structure, about, by byte of its arrays

std::string inGigabytes(uint64_t bytes) {
  std::array<char, 32> text{};
  const double gigabytes = 1e-9 * static_cast<double>(bytes);
  std::snprintf(text.data(), text.size(), gigabytes < 0.1 ? "%.2g GB" : "%.1f GB", gigabytes);
  return text.data();
}

}  // namespace

void PageTraffic::begin() { pages_.clear(), fetches_ = bytes_ = 0; }

void PageTraffic::fetched(const Hash128& page, size_t bytes) {
  ++fetches_;
  if (pages_.insert(page).second) bytes_ += bytes;
}

std::string PageTraffic::end(size_t memory) {
  if (fetches_ < kOverAndOver * pages_.size() || bytes_ < 2 * reported_ || pages_.empty()) return {};
  reported_ = bytes_;
  return "images are slow: the rays of one image hit about " + inGigabytes(bytes_ * (1 + kStructure)) +
         " of geometry and structures on this rank, but only " + inGigabytes(memory) +
         " are free for them, so each page was fetched " + std::to_string(fetches_ / pages_.size()) +
         " times; give ranks more memory (--memory), or start more ranks";
}

}  // namespace gluray::cluster
