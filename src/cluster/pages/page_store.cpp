#include "cluster/pages/page_store.h"

#include <sys/mman.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <new>
#include <utility>

namespace gluray::cluster {
namespace {

/// Addresses for so many bytes, which take memory once they are written.
std::shared_ptr<std::byte> reserved(size_t bytes) {
  const size_t size = std::max<size_t>(bytes, 1);
  void* const at =
      mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (at == MAP_FAILED) throw std::bad_alloc();
  return {static_cast<std::byte*>(at), [size](std::byte* from) { munmap(from, size); }};
}

/// Whether all elements are below `end`.
bool allBelow(const scene::Attribute& a, uint32_t count, uint32_t end) {
  uint32_t most = 0;
  for (uint32_t i = 0; i < count; ++i) {
    uint32_t element;
    std::memcpy(&element, a.data + size_t{4} * i, sizeof element);
    most = std::max(most, element);
  }
  return count == 0 || most < end;
}

}  // namespace

class PageStore::Fetched final : public PageResidence {
 public:
  Fetched(PageStore& store, const PageName& name, std::shared_ptr<std::byte> memory, size_t bytes)
      : PageResidence(name), store_(store), memory_(std::move(memory)), bytes_(bytes) {}

  bool load() noexcept override {
    try {
      if (!store_.fetch(name, memory_.get(), bytes_)) return false;
      if (isRight()) return true;
      fail("a page is not what its name says");
    } catch (const std::exception& error) { fail(error.what()); }
    return false;
  }
  void fail(const char* why) noexcept override { store_.fail(why); }
  void drop() noexcept override { madvise(memory_.get(), bytes_, MADV_DONTNEED); }
  size_t bytes() const noexcept override { return bytes_; }
  size_t budget() const noexcept override { return store_.budget(); }

  const std::shared_ptr<std::byte>& memory() const { return memory_; }
  PageLimits limits;

 private:
  bool isRight() const {
    return (!limits.indices || allBelow(limits.indices, limits.corners, limits.vertices)) &&
           (!limits.materials || allBelow(limits.materials, limits.vertices, name.mostMaterial + 1));
  }

  PageStore& store_;
  const std::shared_ptr<std::byte> memory_;
  const size_t bytes_;
};

PageStore::PageStore(const ArrayStore& arrays, Outbox& outbox, size_t memory,
                     std::function<void(const std::string&)> say, std::chrono::milliseconds patience)
    : arrays_(arrays), outbox_(outbox), memory_(memory), say_(std::move(say)), patience_(patience) {}

PageSource::Made PageStore::make(const Hash128& identity, const PageName& name, size_t bytes) {
  const std::lock_guard lock(mutex_);
  if (pages_.size() >= pagesAtMost_) {
    std::erase_if(pages_, [](const auto& one) { return one.second.expired(); });
    pagesAtMost_ = 2 * pages_.size() + 64;
  }
  std::weak_ptr<Fetched>& known = pages_[identity];
  std::shared_ptr<Fetched> page = known.lock();
  if (!page) known = page = std::make_shared<Fetched>(*this, name, reserved(bytes), bytes);
  return {page, page->memory()};
}

void PageStore::limit(PageResidence& page, const PageLimits& limits) {
  PageLimits& own = static_cast<Fetched&>(page).limits;
  own = limits;
  own.indices.owner.reset(), own.materials.owner.reset();  // the page keeps them alive
}

size_t PageStore::budget() const {
  const size_t taken = arrays_.bytes();
  return std::max(memory_ - std::min(taken, memory_), memory_ / 4);
}

void PageStore::begin(std::function<bool()> stop) {
  const std::lock_guard lock(mutex_);
  stop_ = std::move(stop);
  failure_.clear(), failed_ = false;
  traffic_.begin();
}

std::string PageStore::end() {
  std::string failure, slow;
  {
    const std::lock_guard lock(mutex_);
    stop_ = nullptr;
    if (failed_ && failure_.empty()) failure_ = "out of memory while tracing";
    failure = std::exchange(failure_, {});
    slow = traffic_.end(budget());
  }
  if (!slow.empty()) say_(slow);
  return failure;
}

void PageStore::fail(const char* why) noexcept {
  failed_ = true;
  try {
    const std::lock_guard lock(mutex_);
    if (failure_.empty()) failure_ = why;
  } catch (const std::exception&) {}  // no memory for the reason
}

bool PageStore::fetch(const PageName& name, std::byte* to, size_t bytes) {
  Awaited page{to, bytes};
  std::unique_lock lock(mutex_);
  const auto stops = [&] { return failed_ || (stop_ && stop_()); };
  if (stops()) return false;
  const auto at = awaited_.emplace(name.id, &page);
  outbox_.push(name.owner, forRanks(PageWanted{name.id}));
  const bool ended = came_.wait_for(lock, patience_, [&] { return page.came || page.gone || stops(); });
  awaited_.erase(at);
  if (page.came) return traffic_.fetched(name.id, bytes), true;
  if (stops()) return false;
  failed_ = true;
  failure_ = "rank " + std::to_string(name.owner) +
             (ended ? " no longer has the geometry" : " does not send its geometry");
  return false;
}

void PageStore::receivePage(PageGiven given) {
  {
    const std::lock_guard lock(mutex_);
    const auto [begin, end] = awaited_.equal_range(given.id);
    for (auto at = begin; at != end; ++at) {
      Awaited& page = *at->second;
      page.gone = given.bytes.size() != page.bytes;
      page.came = !page.gone;
      if (page.came) std::memcpy(page.to, given.bytes.data(), given.bytes.size());
    }
  }
  came_.notify_all();
}

void PageStore::wake() {
  { const std::lock_guard lock(mutex_); }  // whoever waits has looked at `stop` before, or looks after this
  came_.notify_all();
}

}  // namespace gluray::cluster
