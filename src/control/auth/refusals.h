// Blocks addresses after failed authentication: three failures within a minute block an address for a minute.
// On the hub's thread.
#pragma once
#include <array>
#include <chrono>
#include <cstddef>
#include <map>
#include <string>

namespace gluray::control {

class Refusals {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr size_t kMaxAddresses = 1024;  // then the address whose last failure is oldest is forgotten

  void failed(const std::string& address, Time now);
  bool refused(const std::string& address, Time now) const;
  size_t addresses() const { return failures_.size(); }

 private:
  static constexpr std::chrono::minutes kWindow{1}, kRefusal{1};
  struct Failures {
    std::array<Time, 2> before{};  // the last failures before `last`, oldest first; Time{}: none
    Time last{};
    Time refusedUntil{};
  };
  std::map<std::string, Failures> failures_;
};

}  // namespace gluray::control
