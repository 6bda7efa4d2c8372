#include "tests/fuzz/control/messages.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace gluray::fuzz {
namespace {

using nlohmann::json;
using std::chrono::milliseconds;

template <class List>
const auto& oneOf(Random& random, const List& list) {
  return list[random.below(static_cast<uint32_t>(std::size(list)))];
}

json anyValue(Random& random, int depth = 0) {
  switch (random.below(depth < 4 ? 14 : 11)) {
    case 0: return nullptr;
    case 1: return random.chance(50);
    case 2: return -1;
    case 3: return random.below(5);
    case 4: return random.next();
    case 5: return 0.1 * random.below(100);
    case 6: return 1e300;
    case 7: return std::string(random.below(100), 'x');
    case 8: return "all";
    case 9: return std::string("\xc3\xbc \n\"\\");
    case 10: return int64_t{1} << 53;
    case 11: return json::array();
    case 12: {
      json list = json::array();
      for (uint32_t i = random.below(4); i > 0; --i) list.push_back(anyValue(random, depth + 1));
      return list;
    }
    default: return {{"ao", anyValue(random, depth + 1)}};
  }
}

json programOf(Random& random) {
  switch (random.below(4)) {
    case 0: return "all";
    case 1: return json::array({1 + random.below(5), 1 + random.below(5)});
    default: return 1 + random.below(4);
  }
}

json request(Random& random, int depth = 0) {
  static const std::array<const char*, 9> types{"list", "get",  "describe", "set", "set",
                                                "undo", "redo", "observe",  "call"};
  json message{{"type", oneOf(random, types)}, {"program", programOf(random)}};
  if (random.chance(50)) message["names"] = {"ao", "shadows"};
  message["name"] = "still";
  message["values"] = {{"ao", random.chance(50)}, {"v" + std::to_string(random.below(3)), anyValue(random)}};
  if (random.chance(60)) message["gesture"] = random.chance(80) ? "drag" : "other";
  static const std::array<const char*, 4> events{"state", "settings", "programs", "thumbnail"};
  message["what"] = json::array();
  for (uint32_t i = random.below(4); i > 0; --i) message["what"].push_back(oneOf(random, events));
  if (random.chance(50)) message["every"] = 0.05 * (1 + random.below(40));
  if (depth == 0 && random.chance(5)) {
    message = {{"type", "batch"}, {"requests", json::array()}};
    for (uint32_t i = random.below(6); i > 0; --i) message["requests"].push_back(request(random, 1));
  }
  return message;
}

json hello(Random& random, bool program) {
  json message{{"type", "hello"}, {"version", 1 + random.below(3)}, {"role", program ? "program" : "client"}};
  if (!program) return message;
  const uint32_t ranks = random.chance(40) ? 2 + random.below(2) : 1;
  message.update({{"pid", 1 + random.below(9)}, {"host", "h"}, {"name", "p"}, {"ranks", ranks}});
  message["rank"] = random.below(ranks);
  message["job"] = ranks > 1 ? "job" : "";
  return message;
}

/// What a program answers: mostly what is right for this question.
json answerTo(Random& random, const json& question) {
  json answer{{"type", "answer"}, {"id", question["id"]}};
  if (random.chance(15)) return answer["why"] = "no", answer;
  json result{{"frame", random.below(100)}, {"values", json::object()}};
  if (question.contains("hold"))
    result = {{"frame", random.below(100)}, {"drawing", random.chance(50)}, {"age", 0.01}, {"period", 0.1}};
  if (random.chance(10)) result["late"] = true;
  if (random.chance(10)) result = anyValue(random);
  answer["results"] = json::array({result});
  return answer;
}

void mutate(Random& random, json& message) {
  if (message.empty()) return;
  auto member = message.begin();
  std::advance(member, random.below(static_cast<uint32_t>(message.size())));
  if (random.chance(40))
    message.erase(member);
  else
    *member = anyValue(random);
}

void mutate(Random& random, std::string& line) {
  for (uint32_t i = 1 + random.below(4); i > 0 && !line.empty(); --i) {
    const size_t at = random.below(static_cast<uint32_t>(line.size()));
    const size_t count = random.below(8);
    switch (random.below(5)) {
      case 0: line[at] = static_cast<char>(random.below(256)); break;
      case 1: line.erase(at, count); break;
      case 2: line.insert(at, line.substr(random.below(static_cast<uint32_t>(line.size())), count)); break;
      case 3: line.insert(at, "0"); break;
      default: line.insert(at, 1 + random.below(20), "[{\"9"[random.below(4)]); break;
    }
  }
}

std::string lineFor(Random& random, json message) {
  const uint32_t kind = random.below(100);
  if (kind < 25) mutate(random, message);
  std::string line = control::lineOf(message);
  if (kind > 97) mutate(random, line);
  return line;
}

/// What one peer sends now.
std::string nextLine(Random& random, HubPlayer& player, size_t peer, bool program) {
  if (!program) {
    json message = request(random);
    message["id"] = random.chance(95) ? json(random.below(400)) : anyValue(random);
    return lineFor(random, std::move(message));
  }
  std::string lines;
  for (const json& question : player.questions(peer))
    if (random.chance(90)) lines += lineFor(random, answerTo(random, question));
  if (!lines.empty() && random.chance(80)) return lines;
  static const std::array<const char*, 4> events{"state", "settings", "thumbnail", "nothing"};
  return lines +
         lineFor(random, {{"type", "event"}, {"what", oneOf(random, events)}, {"state", anyValue(random)}});
}

}  // namespace

namespace {

/// Some peers, those that were closed included, and which of them are programs.
struct Session {
  HubPlayer player;
  std::vector<bool> programs;

  void connect(Random& random) {
    programs.push_back(random.chance(50));
    const size_t peer = player.connect();
    json first = hello(random, programs.back());
    if (random.chance(5)) mutate(random, first);
    player.feed(peer, control::lineOf(first));
  }
  /// Something else than a message; false: nothing.
  bool disturb(Random& random, size_t peer) {
    const uint32_t kind = random.below(100);
    if (kind < 1) player.disconnect(peer);
    if (kind >= 1 && kind < 4) player.slow(peer, random.chance(50));
    if (kind >= 4 && kind < 15) player.wait(milliseconds(random.below(random.chance(10) ? 4000 : 100)));
    return kind < 15;
  }
};

}  // namespace

HubPlayer::Counts playSession(uint64_t seed) {
  constexpr uint32_t kMinSteps = 100, kMaxExtraSteps = 400, kMaxOpen = 10;
  Random random(seed);
  Session session;
  HubPlayer& player = session.player;
  std::vector<size_t> open;
  for (uint32_t steps = kMinSteps + random.below(kMaxExtraSteps); steps > 0; --steps) {
    open.clear();
    for (size_t peer = 0; peer < player.peers(); ++peer)
      if (player.open(peer)) open.push_back(peer);
    if (open.size() < 3 || (open.size() < kMaxOpen && random.chance(8))) {
      session.connect(random);
      continue;
    }
    const size_t peer = oneOf(random, open);
    if (session.disturb(random, peer)) continue;
    const std::string line = nextLine(random, player, peer, session.programs[peer]);
    const size_t cut = random.below(static_cast<uint32_t>(line.size()) + 1);
    player.feed(peer, std::string_view(line).substr(0, cut));
    player.feed(peer, std::string_view(line).substr(cut));
  }
  player.end();
  return player.counts();
}

void playBytes(std::string_view bytes) {
  constexpr size_t kPeers = 6;
  HubPlayer player;
  for (size_t peer = 0; peer < kPeers; ++peer) {
    player.connect();
    Random random(peer);
    player.feed(peer, control::lineOf(hello(random, peer % 2 == 0)));
  }
  // Pieces after a byte that says whose they are, or that something else happens.
  while (!bytes.empty()) {
    const auto what = static_cast<unsigned char>(bytes.front());
    bytes.remove_prefix(1);
    const size_t peer = what % kPeers;
    const size_t end = std::min(bytes.find('\n'), bytes.size());
    if (what < 8) player.wait(milliseconds(1 << what));
    if (what >= 8 && what < 16) player.slow(peer, what % 2 == 0);
    if (what < 16) continue;
    std::string piece(bytes.substr(0, end));
    if (what < 224) piece += '\n';
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
    player.feed(peer, piece);
    for (const json& question : player.questions(peer)) {
      Random random(what);
      if (what % 3 != 0) player.feed(peer, control::lineOf(answerTo(random, question)));
    }
  }
  player.end();
}

}  // namespace gluray::fuzz
