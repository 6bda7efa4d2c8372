#include "cluster/arrays/array_intake.h"

#include "cluster/messages/rank_messages.h"

#include <tbb/parallel_for.h>

#include <utility>

namespace gluray::cluster {

ArrayIntake::ArrayIntake(ArrayStore& store, Outbox& outbox, int self, int threads)
    : store_(store), outbox_(outbox), self_(self), arena_(threads), thread_([this] { run(); }) {}

ArrayIntake::~ArrayIntake() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  more_.notify_all();
  thread_.join();
}

void ArrayIntake::add(uint64_t number, const Hash128& name, Array array) {
  {
    const std::lock_guard lock(mutex_);
    checks_.push_back({number, name, std::move(array)});
  }
  more_.notify_all();
}

void ArrayIntake::run() {
  for (;;) {
    std::vector<Check> checks;
    {
      std::unique_lock lock(mutex_);
      more_.wait(lock, [this] { return ends_ || !checks_.empty(); });
      if (ends_) return;
      checks.swap(checks_);
    }
    arena_.execute([&] { tbb::parallel_for(size_t{0}, checks.size(), [&](size_t i) { check(checks[i]); }); });
  }
}

void ArrayIntake::check(Check& one) {
  const auto bytes = one.array.bytes;
  const bool isRight = hashBytes(bytes.data(), bytes.size()) == one.name;
  // A wrong one counts, too: the program that sent it will be taken to have forgotten it.
  store_.put(self_, one.name, isRight ? std::move(one.array) : Array{});
  outbox_.push(self_, forRanks(ArrayChecked{one.number, one.name, isRight}));
}

}  // namespace gluray::cluster
