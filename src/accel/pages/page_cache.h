// Keeps the most recently used pages in memory, within the budget of their residences. Owned by World;
// tracing threads.
#pragma once
#include "accel/device/device.h"
#include "accel/meshes/iota_indices.h"
#include "accel/pages/page.h"

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <set>
#include <utility>
#include <vector>

namespace gluray::accel {

/// A page's structure may be freed while no ray is in it. Its arrays stay while a reader may hold a hit on
/// it. Pages that readers use at the same time may exceed the budget.
class PageCache {
 public:
  explicit PageCache(const Device& device) : device_(device) {}
  PageCache(const PageCache&) = delete;
  PageCache& operator=(const PageCache&) = delete;

  /// Its lifetime spans queries and the use of their hits, on one thread.
  class Reader {
   public:
    explicit Reader(PageCache& cache) : cache_(cache.pages_ > 0 ? &cache : nullptr) {
      if (cache_) at_ = cache_->startReading();
    }
    ~Reader() {
      if (cache_) cache_->endReading(at_);
    }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

   private:
    PageCache* cache_;
    uint64_t at_ = 0;
  };

  uint64_t loads() const { return loads_; }  // since the start
  /// Bytes of arrays and structures in memory, and their peak.
  size_t bytes() const { return bytes_; }
  size_t mostBytes() const { return mostBytes_; }

 private:
  friend class Page;
  using Lock = std::unique_lock<std::mutex>;
  /// Throws std::bad_alloc.
  void add(Page& page);
  void remove(Page& page);
  /// Loads the page for a thread that enters it. Null if it cannot be loaded.
  RTCSceneTy* load(Page& page) noexcept;
  bool build(Page& page, Lock& lock);
  /// Frees unused pages, least recently used first, until the others take at most `most` bytes.
  void makeRoom(size_t most) noexcept;
  bool retire(Page& page) noexcept;
  void drop(Page& page) noexcept;
  void count(size_t gone, size_t come) noexcept;
  uint64_t startReading();
  void endReading(uint64_t at);
  void sweep() noexcept;

  const Device& device_;
  IotaIndices iota_;
  std::atomic<size_t> pages_{0};
  std::atomic<uint64_t> clock_{1};  // counts loads
  std::atomic<uint64_t> loads_{0};
  std::atomic<size_t> bytes_{0}, mostBytes_{0};

  std::mutex mutex_;
  std::condition_variable came_;
  // Reserved for all pages, so that nothing is allocated while a thread waits for a page.
  std::vector<Page*> ready_, retired_;
  std::vector<std::pair<uint64_t, Page*>> byUse_;  // of makeRoom()
  std::multiset<uint64_t> readers_;                // by the clock of their start
};

}  // namespace gluray::accel
