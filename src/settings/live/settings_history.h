// The steps by which settings were set live, for undo and redo. Not thread-safe: used by the control thread.
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

  /// Adds a step; steps that were undone are forgotten. A step continues the previous one if both have the
  /// same non-empty gesture. Changes without effect are not steps, and a gesture that ends where it began is
  /// removed. `before`: as in LiveSettings::Answer.
  void add(const Changes& changes, const Changes& before, const std::string& gesture);

  size_t undoSteps() const { return made_; }
  size_t redoSteps() const { return steps_.size() - made_; }
  /// The changes that undo the last step. Requires such a step.
  Changes undoing() const;
  /// The changes that redo the next step. Requires such a step.
  Changes redoing() const;
  /// Call when the changes of undoing() were made.
  void undone();
  /// Call when the changes of redoing() were made.
  void redone();

 private:
  struct Step {
    Changes before, after;  // values of the same settings, in the same order
    std::string gesture;
  };
  bool continues(const std::string& gesture) const;

  std::deque<Step> steps_;
  size_t made_ = 0;      // steps that are not undone
  bool closed_ = false;  // the last step was undone and redone: nothing continues it
};

}  // namespace gluray
