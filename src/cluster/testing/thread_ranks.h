// A job whose ranks are threads of one process, for tests.
#pragma once
#include "cluster/ranks/ranks.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

namespace gluray::cluster::test {

/// What the ranks share.
class ThreadJob {
 public:
  explicit ThreadJob(int ranks) : inboxes(static_cast<size_t>(ranks)) {}
  struct Broadcast {
    std::vector<std::byte> bytes;
    bool posted = false;
    int copies = 0;
  };
  std::mutex mutex;
  std::vector<std::deque<RankMessage>> inboxes;
  std::map<uint64_t, Broadcast> broadcasts;  // by number
  std::atomic<uint64_t> sentBytes{0};
};

/// One of them. Its thread owns it.
class ThreadRanks final : public Ranks {
 public:
  ThreadRanks(std::shared_ptr<ThreadJob> job, int rank) : job_(std::move(job)), rank_(rank) {}
  int rank() const override { return rank_; }
  int size() const override { return static_cast<int>(job_->inboxes.size()); }
  int rankHere() const override { return rank_; }
  int sizeHere() const override { return size(); }
  std::string implementation() const override { return "threads"; }
  void send(int to, std::vector<std::byte> message) override {
    const std::lock_guard lock(job_->mutex);
    if (to != rank_) job_->sentBytes += message.size();
    job_->inboxes[static_cast<size_t>(to)].push_back({rank_, std::move(message)});
  }
  std::optional<RankMessage> receive() override {
    const std::lock_guard lock(job_->mutex);
    auto& inbox = job_->inboxes[static_cast<size_t>(rank_)];
    if (inbox.empty() || isDeaf) return std::nullopt;
    RankMessage message = std::move(inbox.front());
    inbox.pop_front();
    return message;
  }
  void broadcast(int root, std::span<std::byte> bytes, std::function<void()> done) override {
    pending_.push_back({next_++, root, bytes, std::move(done)});
  }
  void progress() override {
    if (isSlow) return;
    for (auto it = pending_.begin(); it != pending_.end();) {
      if (!isOver(*it)) {
        ++it;
        continue;
      }
      const auto done = std::move(it->done);
      it = pending_.erase(it);
      done();
    }
  }
  bool busy() const override { return !pending_.empty(); }

  std::atomic<bool> isDeaf{false};  // receives nothing, as a stopped process
  std::atomic<bool> isSlow{false};  // broadcasts do not come to their end

 private:
  struct Pending {
    uint64_t number;
    int root;
    std::span<std::byte> bytes;
    std::function<void()> done;
    bool taken = false;
  };
  bool isOver(Pending& one) {
    const std::lock_guard lock(job_->mutex);
    ThreadJob::Broadcast& shared = job_->broadcasts[one.number];
    if (one.root == rank_ && !shared.posted)
      shared.bytes.assign(one.bytes.begin(), one.bytes.end()), shared.posted = true;
    if (!shared.posted) return false;
    if (one.root != rank_) {
      // As MPI's: whoever expects another size has called it in another order.
      if (shared.bytes.size() != one.bytes.size()) throw RanksFailed("broadcasts do not match");
      std::copy(shared.bytes.begin(), shared.bytes.end(), one.bytes.begin());
    }
    if (++shared.copies == size()) job_->broadcasts.erase(one.number);
    return true;
  }

  std::shared_ptr<ThreadJob> job_;
  int rank_;
  uint64_t next_ = 0;
  std::deque<Pending> pending_;
};

}  // namespace gluray::cluster::test
