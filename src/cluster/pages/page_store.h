// The pages of this rank's images; fetches them from their owners when rays hit them.
#pragma once
#include "cluster/arrays/array_store.h"
#include "cluster/messages/page_messages.h"
#include "cluster/pages/page_traffic.h"
#include "cluster/ranks/outbox.h"
#include "cluster/stream/page_layout.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>

namespace gluray::cluster {

class PageStore final : public PageSource {
 public:
  /// Owners read gigabytes of programs between messages.
  static constexpr std::chrono::milliseconds kPatience{10'000};

  /// `memory`: maximum bytes of arrays, pages and structures. `patience`: timeout for fetching a page. `say`:
  /// one line for the user, any thread. All must outlive it.
  PageStore(const ArrayStore& arrays, Outbox& outbox, size_t memory,
            std::function<void(const std::string&)> say, std::chrono::milliseconds patience = kPatience);

  /// Any thread. The store must outlive the page.
  Made make(const Hash128& identity, const PageName& name, size_t bytes) override;
  void limit(PageResidence& page, const PageLimits& limits) override;

  // The tracing thread.
  /// Begins an image. Threads that wait for pages stop when `stop` returns true; `stop` is checked after
  /// wake().
  void begin(std::function<bool()> stop);
  /// Whether pages are missing, so that tiles traced since then are wrong. Any thread.
  bool hasFailed() const { return failed_; }
  /// Ends the image. Returns the reason why pages were missing; empty: none, or stopped.
  std::string end();

  // The main thread.
  void receivePage(PageGiven given);
  void wake();

  size_t budget() const;

 private:
  class Fetched;
  /// Waits for the page's bytes. Returns false if they cannot be fetched.
  bool fetch(const PageName& name, std::byte* to, size_t bytes);
  void fail(const char* why) noexcept;

  struct Awaited {
    std::byte* to = nullptr;
    size_t bytes = 0;
    bool came = false, gone = false;
  };
  const ArrayStore& arrays_;
  Outbox& outbox_;
  const size_t memory_;
  const std::function<void(const std::string&)> say_;
  const std::chrono::milliseconds patience_;
  std::mutex mutex_;
  PageTraffic traffic_;
  std::unordered_map<Hash128, std::weak_ptr<Fetched>> pages_;
  size_t pagesAtMost_ = 64;  // number of entries at which expired ones are removed
  std::condition_variable came_;
  std::unordered_multimap<Hash128, Awaited*> awaited_;
  std::function<bool()> stop_;
  std::string failure_;
  std::atomic<bool> failed_{false};
};

}  // namespace gluray::cluster
