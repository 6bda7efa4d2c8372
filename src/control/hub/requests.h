// Client requests: checks them, forwards them, and collects results. On the hub's thread.
#pragma once
#include "control/hub/change_queue.h"
#include "control/hub/observers.h"

#include <functional>
#include <string>
#include <vector>

namespace gluray::control {

inline constexpr size_t kMaxBatchSize = 256;
inline constexpr std::chrono::seconds kPatience{10};  // time limit of requests that change nothing

class Requests {
 public:
  /// Receives the members of the answer: `results`, `programs`, `answers`, or `why`.
  using Done = std::function<void(nlohmann::json&& body)>;

  Requests(Programs& programs, Questions& questions, ChangeQueue& changes, Observers& observers)
      : programs_(programs), questions_(questions), changes_(changes), observers_(observers) {}

  /// Carries out a request with any contents. Calls `done` once, perhaps before it returns.
  void carryOut(uint64_t client, const nlohmann::json& request, Done done);

 private:
  struct Chosen {
    std::vector<uint64_t> programs;
    bool all = false;
    std::string why;  // if not empty, the request fails
  };
  Chosen chosen(const nlohmann::json& request);
  void carryOutFor(uint64_t client, const std::string& type, const nlohmann::json& request, Done done);
  void change(uint64_t client, const std::string& type, const nlohmann::json& request, const Chosen& chosen,
              Done done);
  void passOn(nlohmann::json message, const Chosen& chosen, Done done);
  void observe(uint64_t client, const nlohmann::json& request, const Chosen& chosen, const Done& done);
  void batch(uint64_t client, const nlohmann::json& request, Done done);

  Programs& programs_;
  Questions& questions_;
  ChangeQueue& changes_;
  Observers& observers_;
};

}  // namespace gluray::control
