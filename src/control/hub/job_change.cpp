#include "control/hub/job_change.h"

#include "control/messages/members.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace gluray::control {
namespace {

using nlohmann::json;
using std::chrono::milliseconds;

constexpr milliseconds kHoldPatience{1000}, kApplyPatience{1000}, kDrawPatience{3000};
constexpr double kMaxSeconds = 1e6;  // maximum valid age or period

/// A number of seconds from 0 to kMaxSeconds; 0 if it is missing.
double secondsOf(const json* value) {
  if (!value || !value->is_number()) return 0;
  const auto seconds = value->get<double>();
  return seconds >= 0 && seconds <= kMaxSeconds ? seconds : 0;
}

std::optional<HeldAt> heldAt(const json& result, HubTime now) {
  const auto frame = wholeNumber(member(result, "frame"), 0, kMaxFrame);
  const json* drawing = member(result, "drawing");
  if (!frame || !drawing || !drawing->is_boolean()) return std::nullopt;
  const std::chrono::duration<double> age(secondsOf(member(result, "age")));
  return HeldAt{*frame, drawing->get<bool>(), now - std::chrono::duration_cast<HubTime::duration>(age),
                secondsOf(member(result, "period"))};
}

/// One change of a job. It keeps itself alive while answers are pending.
class JobChange : public std::enable_shared_from_this<JobChange> {
 public:
  JobChange(Questions& questions, std::map<int, uint64_t> ranks, Questions::Done done)
      : questions_(questions), ranks_(std::move(ranks)), done_(std::move(done)) {}

  void hold(const json& change) {
    askAll(
        kHoldPatience,
        [&](int) {
          json message = change;
          message["hold"] = true;
          return message;
        },
        &JobChange::held);
  }

 private:
  using Answered = void (JobChange::*)(int rank, json&& result);
  template <class MessageOf>
  void askAll(milliseconds patience, MessageOf messageOf, Answered answered) {
    missing_ = ranks_.size();
    for (const auto& [number, connection] : ranks_) {
      const int rank = number;
      const uint64_t id = questions_.ask(connection, messageOf(rank), patience,
                                         [self = shared_from_this(), rank, answered](json&& result) {
                                           if (self->done_) ((*self).*answered)(rank, std::move(result));
                                         });
      if (answered == &JobChange::held) holds_[rank] = id;
    }
  }

  json about(const char* type, int rank) const { return {{"type", type}, {"of", holds_.at(rank)}}; }

  void held(int rank, json&& result) {
    std::string why = whyOf(result);
    const auto at = heldAt(result, questions_.now());
    if (why.empty() && !at) why = "the program's answer is not one of this protocol";
    if (!why.empty()) return drop(rank, why);
    held_[rank] = *at;
    if (--missing_ > 0) return;
    frames_ = framesToApply(held_);
    askAll(
        kApplyPatience,
        [&](int each) {
          json message = about("apply", each);
          message["frame"] = frames_.at(each);
          return message;
        },
        &JobChange::applied);
  }

  void drop(int refusing, const std::string& why) {
    for (const auto& [rank, connection] : ranks_) questions_.tell(connection, about("drop", rank));
    end(failure("rank " + std::to_string(refusing) + ": " + why));
  }

  void applied(int rank, json&& result) {
    note(rank, result);
    const json* late = member(result, "late");
    if (isTrue(late)) late_.push_back(rank);
    if (--missing_ > 0) return;
    // All ranks have the change: a rank that begins a frame now finds the others ready.
    askAll(
        kDrawPatience, [&](int each) { return about("draw", each); }, &JobChange::drawn);
  }

  void drawn(int rank, json&& result) {
    note(rank, result);
    const json* const frame = member(result, "frame");
    const bool began = frame && frame->is_number_integer() && frame->get<int64_t>() > frames_.at(rank);
    if (began && std::find(late_.begin(), late_.end(), rank) == late_.end()) late_.push_back(rank);
    if (rank == 0) result_ = std::move(result);
    if (--missing_ > 0) return;
    if (!why_.empty()) return end(failure(why_));
    if (!late_.empty()) std::sort(late_.begin(), late_.end()), result_["late"] = late_;
    end(std::move(result_));
  }

  /// Keeps the first failure: the ranks may differ afterwards.
  void note(int rank, const json& result) {
    if (const std::string why = whyOf(result); !why.empty() && why_.empty())
      why_ = "rank " + std::to_string(rank) + ": " + why + "; the ranks may differ now";
  }

  void end(json&& result) {
    if (const auto done = std::exchange(done_, nullptr)) done(std::move(result));
  }

  Questions& questions_;
  const std::map<int, uint64_t> ranks_;  // connections
  Questions::Done done_;                 // empty after it has ended
  std::map<int, uint64_t> holds_;        // ids of the requests to hold
  std::map<int, HeldAt> held_;
  std::map<int, int64_t> frames_;  // frames from which the values apply
  std::vector<int> late_;
  std::string why_;
  json result_;
  size_t missing_ = 0;  // pending answers
};

}  // namespace

std::map<int, int64_t> framesToApply(const std::map<int, HeldAt>& held) {
  bool drawing = false;
  double period = 0;
  HubTime first = HubTime::max();
  for (const auto& [rank, at] : held) {
    drawing = drawing || at.drawing;
    period = std::max(period, at.period);
    first = std::min(first, at.began);
  }
  std::map<int, int64_t> ahead;  // frames ahead of the last rank
  int64_t most = 0;
  for (const auto& [rank, at] : held) {
    const double since = std::chrono::duration<double>(at.began - first).count();
    // At most one frame: ranks that wait for each other are never further apart.
    ahead[rank] = drawing && period > 0 && since > period / 2 ? 1 : 0;
    most = std::max(most, ahead[rank]);
  }
  std::map<int, int64_t> frames;
  for (const auto& [rank, at] : held) frames[rank] = at.frame + (drawing ? 2 : 1) + most - ahead[rank];
  return frames;
}

void changeJob(Questions& questions, const std::map<int, uint64_t>& ranks, const json& change,
               Questions::Done done) {
  std::make_shared<JobChange>(questions, ranks, std::move(done))->hold(change);
}

}  // namespace gluray::control
