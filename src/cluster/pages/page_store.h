// The pages that this rank traces in: gets them from their owners when rays meet them.
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

  /// `memory`: bytes that arrays, pages and structures may take. `patience`: how long an owner may take to
  /// give a page. `say`: one line for the user, any thread. All must outlive it.
  PageStore(const ArrayStore& arrays, Outbox& outbox, size_t memory,
            std::function<void(const std::string&)> say, std::chrono::milliseconds patience = kPatience);

  /// Any thread. The store must outlive the page.
  Made make(const Hash128& identity, const PageName& name, size_t bytes) override;
  void limit(PageResidence& page, const PageLimits& limits) override;

  // The tracing thread.
  /// A picture begins. Threads that wait for pages end when `stop`, which is looked at when wake() is called.
  void begin(std::function<bool()> stop);
  /// Whether pages are missing: no tile that was traced since then is right. Any thread.
  bool hasFailed() const { return failed_; }
  /// It has ended. Why pages were missing; empty: none were, or it was stopped.
  std::string end();

  // The main thread.
  void receivePage(PageGiven given);
  void wake();

  size_t budget() const;

 private:
  class Fetched;
  /// Waits for the page's bytes. False: they do not come.
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
  size_t pagesAtMost_ = 64;  // before those that are gone are removed
  std::condition_variable came_;
  std::unordered_multimap<Hash128, Awaited*> awaited_;
  std::function<bool()> stop_;
  std::string failure_;
  std::atomic<bool> failed_{false};
};

}  // namespace gluray::cluster
