#include "gl/trials/precedents.h"

#include <cmath>

namespace gluray::gl {
namespace {

/// How much two loads differ: the sum of the logarithms of both ratios.
double difference(const FrameLoad& a, const FrameLoad& b) {
  return std::abs(std::log((a.triangles + 1) / (b.triangles + 1))) +
         std::abs(std::log((a.pixels + 1) / (b.pixels + 1)));
}

}  // namespace

bool Precedent::isSane() const {
  const auto isPositive = [](double seconds) { return std::isfinite(seconds) && seconds > 0; };
  const auto isCount = [](double count) { return std::isfinite(count) && count >= 0; };
  return isPositive(traced) && isPositive(direct) && isCount(load.triangles) && isCount(load.pixels);
}

std::optional<Precedent> Precedents::find(const FrameLoad& load) const {
  const std::lock_guard lock(mutex_);
  std::optional<Precedent> best;
  for (const Precedent& precedent : list_)
    if (within(precedent.load, load, kSame) &&
        (!best || difference(precedent.load, load) < difference(best->load, load)))
      best = precedent;
  return best;
}

void Precedents::add(const Precedent& precedent) {
  if (!precedent.isSane()) return;
  const std::lock_guard lock(mutex_);
  std::erase_if(list_, [&](const Precedent& old) { return within(old.load, precedent.load, kSame); });
  if (list_.size() >= kMost) list_.erase(list_.begin());
  list_.push_back(precedent);
}

std::vector<Precedent> Precedents::all() const {
  const std::lock_guard lock(mutex_);
  return list_;
}

}  // namespace gluray::gl
