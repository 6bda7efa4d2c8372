#include "control/images/refined_state.h"

#include "control/messages/members.h"

#include <chrono>

namespace gluray::launcher {
namespace {

using nlohmann::json;
using std::chrono::steady_clock;

constexpr double kEvery = 0.1;          // seconds between states
constexpr double kFirstSeconds = 1;     // until the first one
constexpr double kMaxPassSeconds = 60;  // seconds a frame
// Seconds without a pass, after which none is expected. Programs begin to refine at most 3 s after a frame;
// an image that they have refined before is finished at once.
constexpr double kBegin = 4, kStall = 10;

double secondsSince(steady_clock::time_point begin) {
  return std::chrono::duration<double>(steady_clock::now() - begin).count();
}

/// A member that counts something; 0 where it does not.
int64_t countIn(const json& state, const char* name) {
  return control::wholeNumber(control::member(state, name), 0, control::kMaxFrame).value_or(0);
}

}  // namespace

RefinedState::RefinedState(HubSession& hub, const RunningProgram& program, int64_t passes)
    : hub_(hub), passes_(passes) {
  const json values = valuesIn(hub, program, {"refine.idle", "refine.passes", "noise"});
  if (values["refine.idle"] == false)
    throw std::runtime_error("--passes needs refine.idle = true; use gluray set refine.idle=on");
  most_ = countIn(values, "refine.passes");
  noise_ = control::numberIn<double>(values, "noise", 0);
  hub.ask({{"type", "observe"}, {"program", numbersOf({program})}, {"what", {"state"}}, {"every", kEvery}});
  before_ = countIn(awaitState(kFirstSeconds), "passes");
}

json RefinedState::awaitState(double seconds) {
  const json event = hub_.client().awaitEvent(seconds);
  if (event.is_null() && !hub_.client().whyClosed().empty())
    throw std::runtime_error(hub_.client().whyClosed());
  return control::textIn(event, "what") == "state" ? event.value("state", json()) : json();
}

bool RefinedState::wait(std::optional<int64_t> frame, const std::function<bool()>& stopped) {
  while (!hub_.client().awaitEvent(0).is_null()) {  // states of earlier moments
  }
  const auto begin = steady_clock::now();
  auto progress = begin;
  double patience = kBegin;
  int64_t passes = before_;
  // While a new frame's image has no passes, the state still has those of the image before.
  bool own = !frame || before_ == 0;
  while (secondsSince(begin) < kMaxPassSeconds && secondsSince(progress) < patience && !stopped()) {
    const json state = awaitState(2 * kEvery);
    if (!state.is_object() || countIn(state, "frame") < frame.value_or(0)) continue;
    const int64_t now = countIn(state, "passes");
    if (now != passes) own = true, patience = kStall, progress = steady_clock::now();
    passes = now;
    const bool finished = now >= most_ || control::numberIn<double>(state, "noise", 1) <= noise_;
    if (own && now > 0 && (now >= passes_ || finished)) break;
  }
  before_ = passes;
  return passes >= passes_;
}

}  // namespace gluray::launcher
