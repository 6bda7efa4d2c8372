// A counter that one thread writes and any thread reads.
#pragma once
#include <atomic>

namespace gluray::gl {

/// A relaxed atomic with one writer. A write costs as much as a write to a plain number. Readers may see a
/// slightly old value.
template <class T>
class Counter {
 public:
  Counter(T value = {}) : value_(value) {}
  Counter(const Counter& other) : value_(T{other}) {}
  Counter& operator=(const Counter& other) { return *this = T{other}; }
  Counter& operator=(T value) {
    value_.store(value, std::memory_order_relaxed);
    return *this;
  }
  operator T() const { return value_.load(std::memory_order_relaxed); }
  Counter& operator+=(T more) { return *this = T{*this} + more; }
  Counter& operator-=(T less) { return *this = T{*this} - less; }
  Counter& operator++() { return *this += T{1}; }

 private:
  std::atomic<T> value_;
};

}  // namespace gluray::gl
