#include "tests/network/cables.h"

#include <algorithm>
#include <utility>

namespace network {
namespace {

constexpr size_t kHeader = 14;    // bytes: two addresses and a type
constexpr size_t kSpares = 1024;  // buffers that are kept

int64_t passageNs(const Cable& cable, size_t bytes) {
  return cable.bitsPerSecond > 0
             ? static_cast<int64_t>(8e9 * static_cast<double>(bytes) / cable.bitsPerSecond)
             : 0;
}

}  // namespace

Cables::Cables(size_t count)
    : cables_(count),
      cut_(count, std::vector<bool>(count, false)),
      bytes_(count, std::vector<uint64_t>(count, 0)) {}

void Cables::setCut(size_t a, size_t b, bool isCut) { cut_[a][b] = cut_[b][a] = isCut; }

std::string Cables::bytesText() const {
  std::string text;
  for (const auto& row : bytes_) {
    if (!text.empty()) text += ';';
    for (const uint64_t bytes : row)
      text += (text.empty() || text.back() == ';' ? "" : " ") + std::to_string(bytes);
  }
  return text;
}

bool Cables::takesFrom(size_t cable, int64_t now) const {
  return cables_[cable].sendsUntil <= now + passageNs(cables_[cable], kSendAheadBytes);
}

void Cables::sent(size_t cable, Bytes frame, int64_t now) {
  if (frame.size() < kHeader) return;
  Cable& own = cables_[cable];
  own.sendsUntil = std::max(own.sendsUntil, now) + passageNs(own, frame.size());
  sending_.push({own.sendsUntil, order_++, cable, 0, std::move(frame)});
}

bool Cables::isCut(size_t from, size_t to) const {
  return cut_[from][from] || cut_[to][to] || cut_[from][to];
}

bool Cables::isLost(size_t from, size_t to) {
  const double arrives = (1 - cables_[from].lostShare) * (1 - cables_[to].lostShare);
  return arrives < 1 && std::uniform_real_distribution<>(0, 1)(random_) >= arrives;
}

void Cables::forwardTo(size_t to, const Travel& travel, Bytes frame) {
  Cable& cable = cables_[to];
  if (isCut(travel.from, to) || isLost(travel.from, to)) return;
  const int64_t waits = std::max<int64_t>(cable.receivesUntil - travel.due, 0);
  if (waits > passageNs(cable, kBufferBytes)) return;  // the switch has no more room
  cable.receivesUntil = travel.due + waits + passageNs(cable, frame.size());
  delivering_.push({cable.receivesUntil + cables_[travel.from].delayNs + cable.delayNs, order_++, travel.from,
                    to, std::move(frame)});
}

void Cables::forward(Travel travel) {
  Address to, from;
  std::copy_n(travel.frame.begin(), to.size(), to.begin());
  std::copy_n(travel.frame.begin() + 6, from.size(), from.begin());
  places_[from] = travel.from;
  if (const auto known = places_.find(to); known != places_.end()) {
    if (known->second != travel.from) forwardTo(known->second, travel, std::move(travel.frame));
    return;
  }
  for (size_t other = 0; other < cables_.size(); ++other)
    if (other != travel.from) forwardTo(other, travel, travel.frame);
}

Cables::Travel Cables::pop(Queue& queue) {
  // top() is constant because changes could break the order; the element leaves at once.
  Travel travel = std::move(const_cast<Travel&>(queue.top()));
  queue.pop();
  return travel;
}

void Cables::advance(int64_t now, const std::function<bool(size_t to, const Bytes& frame)>& deliver) {
  while (!sending_.empty() && sending_.top().due <= now) forward(pop(sending_));
  while (!delivering_.empty() && delivering_.top().due <= now) {
    Travel travel = pop(delivering_);
    if (!isCut(travel.from, travel.to) && deliver(travel.to, travel.frame))
      bytes_[travel.from][travel.to] += travel.frame.size();
    if (spare_.size() < kSpares) spare_.push_back(std::move(travel.frame));
  }
}

int64_t Cables::next(int64_t now) const {
  int64_t time = -1;
  const auto consider = [&](int64_t other) { time = time < 0 ? other : std::min(time, other); };
  if (!sending_.empty()) consider(sending_.top().due);
  if (!delivering_.empty()) consider(delivering_.top().due);
  for (size_t cable = 0; cable < cables_.size(); ++cable)
    if (!takesFrom(cable, now))
      consider(cables_[cable].sendsUntil - passageNs(cables_[cable], kSendAheadBytes));
  return time;
}

Bytes Cables::buffer(size_t size) {
  Bytes frame;
  if (!spare_.empty()) frame = std::move(spare_.back()), spare_.pop_back();
  frame.resize(size);
  return frame;
}

}  // namespace network
