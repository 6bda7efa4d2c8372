// Interval until something is tried again: grows with each try, up to a limit. For backing off from what
// fails.
#pragma once
#include <algorithm>
#include <utility>

namespace gluray {

/// `T`: a number type, such as int for frames or double for seconds.
template <class T>
struct GrowingInterval {
  T first, longest, growth = 2;
  T next = first;
  /// Returns the interval until the next try, and makes the one after it longer.
  T take() { return std::exchange(next, std::clamp(growth * next, first, longest)); }
  void restart() { next = first; }
};

}  // namespace gluray
