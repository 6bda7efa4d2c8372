// The steps by which settings were set live, to take them back and make them again. Not thread-safe: the
// control thread's.
#pragma once
#include "settings/live/live_settings.h"

#include <cstddef>
#include <deque>
#include <string>

namespace gluray {

class SettingsHistory {
 public:
  using Changes = LiveSettings::Changes;
  static constexpr size_t kMaxSteps = 100;

  /// Adds a step; what was taken back is forgotten. A step continues the one before if both have the same
  /// gesture, not empty. Changes that change nothing are no steps, nor are gestures that end where they
  /// began. `before`: as in LiveSettings::Answer.
  void add(const Changes& changes, const Changes& before, const std::string& gesture);

  size_t undoSteps() const { return made_; }
  size_t redoSteps() const { return steps_.size() - made_; }
  /// The changes that take back the last step, or make it again. Require such a step.
  Changes undoing() const;
  Changes redoing() const;
  /// Call when these changes were made.
  void undone();
  void redone();

 private:
  struct Step {
    Changes before, after;  // of the same settings, in the same order
    std::string gesture;
  };
  bool continues(const std::string& gesture) const;

  std::deque<Step> steps_;
  size_t made_ = 0;      // steps that were not taken back
  bool closed_ = false;  // the last step was taken back and made again: nothing continues it
};

}  // namespace gluray
