#include "settings/live/settings_history.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace gluray {

bool SettingsHistory::continues(const std::string& gesture) const {
  return !gesture.empty() && !closed_ && made_ > 0 && made_ == steps_.size() &&
         steps_.back().gesture == gesture;
}

void SettingsHistory::add(const Changes& changes, const Changes& before, const std::string& gesture) {
  Step step = continues(gesture) ? steps_.back() : Step{{}, {}, gesture};
  for (size_t i = 0; i < changes.size() && i < before.size(); ++i) {
    const auto known = std::find_if(step.after.begin(), step.after.end(),
                                    [&](const auto& c) { return c.name == changes[i].name; });
    if (known != step.after.end())
      known->value = changes[i].value;
    else if (changes[i].value != before[i].value)
      step.before.push_back(before[i]), step.after.push_back(changes[i]);
  }
  if (step.after.empty()) return;
  if (continues(gesture)) {
    const bool back = std::equal(step.before.begin(), step.before.end(), step.after.begin(), step.after.end(),
                                 [](const auto& a, const auto& b) { return a.value == b.value; });
    steps_.back() = std::move(step);
    if (back) steps_.pop_back(), made_ = steps_.size();
    return;
  }
  steps_.push_back(std::move(step));  // may throw: nothing has changed then
  steps_.erase(std::next(steps_.begin(), static_cast<std::ptrdiff_t>(made_)), std::prev(steps_.end()));
  if (steps_.size() > kMaxSteps) steps_.pop_front();
  made_ = steps_.size();
  closed_ = false;
}

SettingsHistory::Changes SettingsHistory::undoing() const { return steps_[made_ - 1].before; }
SettingsHistory::Changes SettingsHistory::redoing() const { return steps_[made_].after; }

void SettingsHistory::undone() {
  if (made_ > 0) --made_;
  closed_ = true;
}

void SettingsHistory::redone() {
  if (made_ < steps_.size()) ++made_;
  closed_ = true;
}

}  // namespace gluray
