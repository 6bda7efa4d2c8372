// Whether a rank fetches the pages of one picture over and over, because its memory is too small for what the
// rays meet. One object for each rank; not thread-safe.
#pragma once
#include "base/hash.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_set>

namespace gluray::cluster {

class PageTraffic {
 public:
  /// A picture begins.
  void begin();
  /// A page of so many bytes has come.
  void fetched(const Hash128& page, size_t bytes);
  /// The picture has ended. One line for the user if its pages came several times, unless a picture that met
  /// half as much or more was reported before; else empty. `memory`: bytes that pages may take.
  std::string end(size_t memory);

 private:
  std::unordered_set<Hash128> pages_;
  uint64_t fetches_ = 0;
  uint64_t bytes_ = 0;     // of the different pages
  uint64_t reported_ = 0;  // bytes_ of the picture that was reported last
};

}  // namespace gluray::cluster
