#include "cluster/worker/roll_call.h"

#include "cluster/messages/rank_messages.h"
#include "cluster/worker/facts/rank_facts.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace gluray::cluster {
namespace {

constexpr int kAsking = 0;        // the rank that all say hello to
constexpr double kLongWait = 10;  // seconds

/// "GLuRay 0.1.0 (2) on node7".
std::string described(const std::string& version, const std::string& host) {
  return "GLuRay " + version + (host.empty() ? "" : " on " + host);
}

/// What the sender of a hello is, if that is not `version`; empty: it is. Newer hellos may be longer.
std::string otherKind(std::span<const std::byte> body, const std::string& version) {
  try {
    ReadMessage in(body);
    if (const auto order = in.in().get<uint32_t>(); order != RankHello::kOrder)
      return order == 0x04030201 ? "a machine with another byte order" : "an unknown version of GLuRay";
    RankHello hello;
    in(hello.version);
    in(hello.host);
    return hello.version == version ? "" : described(hello.version, hello.host);
  } catch (const Malformed&) {}
  return "an unknown version of GLuRay";
}

}  // namespace

RollCall::RollCall(Ranks& ranks, std::string version, std::function<void(const std::string&)> say)
    : ranks_(ranks),
      version_(std::move(version)),
      say_(std::move(say)),
      here_(static_cast<size_t>(ranks.size())) {
  if (ranks_.size() == 1)
    isOver_ = true;
  else
    ranks_.send(kAsking, forRanks(RankHello{RankHello::kOrder, version_, hostName()}));
}

void RollCall::takeHello(int from, std::span<const std::byte> body) {
  if (const std::string kind = otherKind(body, version_); !kind.empty())
    throw RanksFailed("rank " + std::to_string(from) + " is of " + kind + ", rank " +
                      std::to_string(kAsking) + " of " + described(version_, hostName()) +
                      ": use one version on all hosts");
  here_[static_cast<size_t>(from)] = true;
  if (isOver_ || std::ranges::find(here_, false) != here_.end()) return;
  for (int rank = 0; rank < ranks_.size(); ++rank) ranks_.send(rank, forRanks(AllAreAlike{}));
}

void RollCall::tick(double now) {
  if (isOver_ || said_ || ranks_.rank() != kAsking) return;
  if (since_ == 0) since_ = now;
  if (now - since_ < kLongWait) return;
  said_ = true;
  std::string missing;
  for (size_t rank = 0; rank < here_.size(); ++rank)
    if (!here_[rank]) missing += (missing.empty() ? "" : ", ") + std::to_string(rank);
  say_("programs must wait until these ranks say which version they are of: " + missing);
}

}  // namespace gluray::cluster
