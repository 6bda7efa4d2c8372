// A job of one process, without MPI.
#pragma once
#include "cluster/ranks/ranks.h"

#include <deque>
#include <utility>

namespace gluray::cluster {

class Alone final : public Ranks {
 public:
  int rank() const override { return 0; }
  int size() const override { return 1; }
  int rankHere() const override { return 0; }
  int sizeHere() const override { return 1; }
  std::string implementation() const override { return "no MPI"; }
  void send(int, std::vector<std::byte> message) override { waiting_.push_back(std::move(message)); }
  std::optional<RankMessage> receive() override {
    if (waiting_.empty()) return std::nullopt;
    RankMessage message{0, std::move(waiting_.front())};
    waiting_.pop_front();
    return message;
  }
  void broadcast(int, std::span<std::byte>, std::function<void()> done) override {
    done_.push_back(std::move(done));
  }
  void progress() override {
    for (const auto& done : std::exchange(done_, {})) done();
  }
  bool busy() const override { return !waiting_.empty() || !done_.empty(); }

 private:
  std::deque<std::vector<std::byte>> waiting_;
  std::vector<std::function<void()>> done_;
};

}  // namespace gluray::cluster
