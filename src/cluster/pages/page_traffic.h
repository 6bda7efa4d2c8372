// Detects that a rank fetches the same pages repeatedly within one image, because its memory is too small.
// One object for each rank; not thread-safe.
#pragma once
#include "base/hash.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_set>

namespace gluray::cluster {

class PageTraffic {
 public:
  /// An image begins.
  void begin();
  /// Reports a fetched page of so many bytes.
  void fetched(const Hash128& page, size_t bytes);
  /// Ends the image. Returns one line for the user if its pages were fetched several times, unless an
  /// earlier report had at least half as many bytes; otherwise empty. `memory`: maximum bytes of pages.
  std::string end(size_t memory);

 private:
  std::unordered_set<Hash128> pages_;
  uint64_t fetches_ = 0;
  uint64_t bytes_ = 0;     // of the different pages
  uint64_t reported_ = 0;  // bytes_ of the image that was reported last
};

}  // namespace gluray::cluster
