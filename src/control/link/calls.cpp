#include "control/link/calls.h"

#include "control/link/apart.h"

#include <exception>
#include <limits>
#include <utility>

namespace gluray::control {

using nlohmann::json;

void Calls::startCall(const std::string& name, const json& id, const json& arguments, double now) {
  if (carryOut(name, id, arguments, now)) return;
  if (waiting_.size() >= kMaxWaiting) return answer_(id, {{"why", "too many calls wait for a frame"}});
  waiting_.push_back({name, id, arguments, FrameWait(source_, now)});
}

/// Carries out the call. Returns false if it must wait for a frame.
bool Calls::carryOut(const std::string& name, const json& id, const json& arguments, double now) {
  if (name == "save" && waker_.disturbs(now)) return false;
  json value;
  std::string why;
  try {
    Called called{};
    inProcess([&] { called = program_.call(name, arguments, value, why); });
    if (called == Called::later) return false;
  } catch (const std::exception& e) { why = std::string("it failed: ") + e.what(); }
  answer_(id, why.empty() ? json{{"value", std::move(value)}} : json{{"why", why}});
  return true;
}

void Calls::passed(double now) {
  bool wake = false;
  std::erase_if(waiting_, [&](Waiting& waiting) {
    if (carryOut(waiting.name, waiting.id, waiting.arguments, now)) return true;
    if (waiting.wait.isOver(now)) {
      answer_(waiting.id,
              {{"why", "it has drawn no frame for 8 seconds; draw in one of its windows, and try again"}});
      return true;
    }
    wake |= !waker_.disturbs(now) && waiting.wait.wakes(now);
    return false;
  });
  if (wake) waker_.wake();
}

double Calls::nextDue(double now) const {
  return waiting_.empty() ? std::numeric_limits<double>::infinity() : now + kPoll;
}

}  // namespace gluray::control
