// Pages that come, that their owner has forgotten, that are wrong, and those whose owner says nothing.
#include "cluster/pages/page_store.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>
#include <future>
#include <thread>
#include <vector>

namespace gluray::cluster {
namespace {

using namespace std::chrono_literals;
constexpr Hash128 kId{7, 9};
constexpr int kOwner = 3;

/// A page of two triangles over four vertices: the memory holds their six indices.
class StoredPage : public testing::Test {
 protected:
  explicit StoredPage(std::chrono::milliseconds patience = 10s)
      : store_(
            arrays_, outbox_, 1000, [this](const std::string& line) { said_ += line; }, patience) {
    made_ = store_.make(kId, {kId, kOwner, 0, {}}, kBytes);
    PageLimits limits;
    limits.indices = scene::Attribute{nullptr, made_.memory.get(), 4, scene::Format::uint32};
    limits.corners = 6, limits.vertices = 4;
    store_.limit(*made_.page, limits);
    store_.begin([this] { return stop_.load(); });
  }

  static std::vector<std::byte> indices(std::vector<uint32_t> numbers) {
    std::vector<std::byte> bytes(numbers.size() * sizeof(uint32_t));
    std::memcpy(bytes.data(), numbers.data(), bytes.size());
    return bytes;
  }
  /// Loads the page on another thread, and waits until it has asked the owner.
  std::future<bool> load() {
    std::future<bool> loaded = std::async(std::launch::async, [this] { return made_.page->load(); });
    while (letters_.empty()) {
      for (Outbox::Letter& letter : outbox_.takeLetters()) letters_.push_back(std::move(letter));
      std::this_thread::sleep_for(1ms);
    }
    return loaded;
  }

  static constexpr size_t kBytes = 6 * sizeof(uint32_t);
  ArrayStore arrays_;
  Outbox outbox_;
  PageStore store_;
  PageSource::Made made_;
  std::vector<Outbox::Letter> letters_;
  std::atomic<bool> stop_{false};
  std::string said_;
};

TEST_F(StoredPage, ComesFromItsOwner) {
  std::future<bool> loaded = load();
  ASSERT_EQ(letters_.size(), 1u);
  EXPECT_EQ(letters_[0].to, kOwner);
  const std::vector<std::byte> bytes = indices({0, 1, 2, 2, 1, 3});
  store_.receivePage({kId, bytes});
  EXPECT_TRUE(loaded.get());
  EXPECT_TRUE(std::equal(bytes.begin(), bytes.end(), made_.memory.get()));
  EXPECT_FALSE(store_.hasFailed());
  EXPECT_EQ(store_.end(), "");
}

TEST_F(StoredPage, ThatOtherPagesDoNotAnswer) {
  std::future<bool> loaded = load();
  store_.receivePage({Hash128{1, 1}, indices({0, 0, 0, 0, 0, 0})});
  EXPECT_EQ(loaded.wait_for(20ms), std::future_status::timeout);
  store_.receivePage({kId, indices({0, 1, 2, 2, 1, 3})});
  EXPECT_TRUE(loaded.get());
}

TEST_F(StoredPage, ThatItsOwnerHasForgotten) {
  std::future<bool> loaded = load();
  store_.receivePage({kId, {}});
  EXPECT_FALSE(loaded.get());
  EXPECT_TRUE(store_.hasFailed());
  EXPECT_EQ(store_.end(), "rank 3 no longer has the geometry");
}

TEST_F(StoredPage, OfAnotherLength) {
  std::future<bool> loaded = load();
  store_.receivePage({kId, indices({0, 1, 2})});
  EXPECT_FALSE(loaded.get());
  EXPECT_TRUE(store_.hasFailed());
}

TEST_F(StoredPage, WithIndicesBeyondItsVertices) {
  std::future<bool> loaded = load();
  store_.receivePage({kId, indices({0, 1, 2, 2, 1, 4})});
  EXPECT_FALSE(loaded.get());
  EXPECT_EQ(store_.end(), "a page is not what its name says");
}

TEST_F(StoredPage, IsNotWaitedForWhenTheImageIsStopped) {
  std::future<bool> loaded = load();
  stop_ = true;
  store_.wake();
  EXPECT_FALSE(loaded.get());
  EXPECT_FALSE(made_.page->load());
  EXPECT_FALSE(store_.hasFailed());
  EXPECT_EQ(store_.end(), "");
}

TEST_F(StoredPage, IsNotAskedForAfterAFailure) {
  made_.page->fail("another page is wrong");
  EXPECT_FALSE(made_.page->load());
  EXPECT_TRUE(outbox_.takeLetters().empty());
  EXPECT_EQ(store_.end(), "another page is wrong");
  // The next image begins anew.
  store_.begin([] { return false; });
  EXPECT_FALSE(store_.hasFailed());
}

TEST_F(StoredPage, ThatComesOverAndOverIsReported) {
  for (int i = 0; i < 5; ++i) {
    letters_.clear();
    std::future<bool> loaded = load();
    store_.receivePage({kId, indices({0, 1, 2, 2, 1, 3})});
    EXPECT_TRUE(loaded.get());
  }
  EXPECT_EQ(said_, "");
  EXPECT_EQ(store_.end(), "");
  EXPECT_NE(said_.find("each page was fetched 5 times"), std::string::npos) << said_;
}

class PageOfASilentOwner : public StoredPage {
 protected:
  PageOfASilentOwner() : StoredPage(50ms) {}
};

TEST_F(PageOfASilentOwner, FailsTheImage) {
  std::future<bool> loaded = load();
  EXPECT_FALSE(loaded.get());
  EXPECT_EQ(store_.end(), "rank 3 does not send its geometry");
  store_.receivePage({kId, indices({0, 1, 2, 2, 1, 3})});  // too late: nobody waits
}

TEST_F(StoredPage, IsOnePageWhileItLives) {
  EXPECT_EQ(store_.make(kId, {kId, kOwner, 0, {}}, kBytes).page, made_.page);
  const std::weak_ptr<PageResidence> former = made_.page;
  made_ = {};
  EXPECT_TRUE(former.expired());
}

TEST_F(StoredPage, HasTheMemoryThatArraysLeave) {
  EXPECT_EQ(store_.budget(), 1000u);
  const auto memory = std::make_shared<std::vector<std::byte>>(600);
  arrays_.put(0, Hash128{1, 2}, {memory, *memory});
  EXPECT_EQ(store_.budget(), 400u);
  const auto more = std::make_shared<std::vector<std::byte>>(5000);
  arrays_.put(0, Hash128{1, 3}, {more, *more});
  EXPECT_EQ(store_.budget(), 250u);  // a quarter at least
}

}  // namespace
}  // namespace gluray::cluster
