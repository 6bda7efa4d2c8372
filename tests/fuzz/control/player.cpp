#include "tests/fuzz/control/player.h"

#include "control/messages/members.h"

#include <cstdio>
#include <cstdlib>
#include <utility>

namespace gluray::fuzz {
namespace {

using control::isId;
using control::member;
using nlohmann::json;

constexpr size_t kMaxQuestions = 1000;  // a program that never answers

void require(bool holds, const char* what, const json& message) {
  if (holds) return;
  std::fprintf(stderr, "control fuzz: %s: %.2000s\n", what,
               message.dump(-1, ' ', false, json::error_handler_t::replace).c_str());
  std::abort();
}

}  // namespace

size_t HubPlayer::connect() {
  const size_t peer = peers_.size();
  peers_.push_back(std::make_unique<One>());
  control::PeerLink link;
  link.send = [this, peer](const control::PeerLink::Line& line) { sent(peer, *line); };
  link.waiting = [this, peer] { return peers_[peer]->waiting; };
  link.finish = [this, peer](const std::string&) { peers_[peer]->open = false; };
  hub_.connected(peer + 1, std::move(link), now_);
  return peer;
}

void HubPlayer::feed(size_t peer, std::string_view bytes) {
  One& one = *peers_[peer];
  if (!one.open) return;
  if (!one.reader.add(bytes)) return disconnect(peer);
  while (one.open) {
    const auto line = one.reader.nextLine();
    if (!line) return;
    const control::Parsed parsed = control::parse(*line);
    if (!parsed.why.empty()) return disconnect(peer);
    message(peer, parsed.message);
  }
}

void HubPlayer::message(size_t peer, const json& message) {
  One& one = *peers_[peer];
  const bool said = one.client || one.program;
  const json* id = member(message, "id");
  const json* type = member(message, "type");
  bool repeated = false;
  if (one.client && *type != "hello" && *type != "error" && isId(id))
    repeated = !one.asked.insert(id->dump()).second;
  const size_t errors = one.errors;
  ++counts_.messages;
  hub_.received(peer + 1, message, now_);
  if (repeated) require(one.errors == errors + 1, "an id that waits must be refused", message);
  if (!said && one.open) {
    one.client = message.value("role", json{}) == "client";
    one.program = !one.client;
    require(*type == "hello", "a connection began without hello", message);
  }
}

void HubPlayer::sent(size_t peer, const std::string& line) {
  One& one = *peers_[peer];
  const control::Parsed parsed = control::parse(std::string_view(line).substr(0, line.size() - 1));
  require(parsed.why.empty() && line.back() == '\n', "the hub sent what nobody reads", json(line));
  const json& message = parsed.message;
  if (message["type"] == "error") ++one.errors;
  if (message["type"] == "answer") {
    const json* id = member(message, "id");
    require(one.client && id && one.asked.erase(id->dump()) == 1, "an answer that nobody waits for", message);
    require(message.contains("why") + message.contains("results") + message.contains("answers") +
                    message.contains("programs") ==
                1,
            "an answer that is none", message);
    ++counts_.answers;
  }
  counts_.asked += one.program && message.contains("id");
  if (one.program && message.contains("id") && one.questions.size() < kMaxQuestions)
    one.questions.push_back(message);
}

void HubPlayer::disconnect(size_t peer) {
  One& one = *peers_[peer];
  one.open = false;
  one.asked.clear();
  hub_.disconnected(peer + 1, now_);
}

void HubPlayer::wait(std::chrono::milliseconds time) { hub_.passed(now_ += time); }

void HubPlayer::slow(size_t peer, bool slow) {
  peers_[peer]->waiting = slow ? size_t{1} << 20 : 0;
  if (!slow) hub_.drained(peer + 1, now_);
}

std::vector<json> HubPlayer::questions(size_t peer) { return std::exchange(peers_[peer]->questions, {}); }

void HubPlayer::end() {
  constexpr int kMaxRounds = 1000;  // a batch of 256 requests that wait 10 s each
  const auto waits = [&] {
    for (const auto& one : peers_)
      if (one->open && !one->asked.empty()) return true;
    return false;
  };
  for (int round = 0; round < kMaxRounds && waits(); ++round) wait(std::chrono::seconds(10));
  for (const auto& one : peers_)
    if (one->open) require(one->asked.empty(), "requests without an answer", json(one->asked));
  require(hub_.nextDue() > now_, "something is due that passed() does not do", json());
}

}  // namespace gluray::fuzz
