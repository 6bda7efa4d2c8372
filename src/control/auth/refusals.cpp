#include "control/auth/refusals.h"

#include <algorithm>

namespace gluray::control {

void Refusals::failed(const std::string& address, Time now) {
  std::erase_if(failures_, [&](const auto& each) {
    return each.second.last + kWindow <= now && each.second.refusedUntil <= now;
  });
  if (failures_.size() >= kMaxAddresses && !failures_.contains(address))
    failures_.erase(std::min_element(failures_.begin(), failures_.end(), [](const auto& a, const auto& b) {
      return a.second.last < b.second.last;
    }));
  Failures& of = failures_[address];
  of.before = {of.before[1], of.last};
  of.last = now;
  if (of.before[0] != Time{} && now - of.before[0] < kWindow) of.refusedUntil = now + kRefusal;
}

bool Refusals::refused(const std::string& address, Time now) const {
  const auto found = failures_.find(address);
  return found != failures_.end() && now < found->second.refusedUntil;
}

}  // namespace gluray::control
