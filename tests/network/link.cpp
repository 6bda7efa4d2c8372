// network_link NAME:PROCESS...: a switch with a cable to each of these network interfaces, for tests. Makes
// the TAP interface NAME in the network namespace of the process. Cables delay, limit, lose and cut frames as
// standard input says, one command a line, each answered by a line; the end of standard input ends it. A
// cable is named by its place in the arguments, from 0. Needs root and /dev/net/tun.
//   delay CABLE MICROSECONDS    each way
//   rate CABLE BITS_PER_SECOND  each way; 0: no limit
//   drop CABLE SHARE            of the frames that arrive by it or leave by it, 0 to 1
//   cut CABLE [CABLE] / join CABLE [CABLE]  the cable, or what two cables say to each other
//   bytes                       of delivered frames, from each cable to each, row by row
#include "tests/network/cables.h"
#include "tests/network/taps.h"

#include <sched.h>
#include <sys/prctl.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <sstream>
#include <string>
#include <vector>

namespace {

using network::Cables;

constexpr size_t kLargestFrame = 9216;  // bytes: larger than the largest MTU in use, 9000
constexpr int kFramesInTurn = 16;       // read of one interface before the others are looked at

std::string answer(const std::string& line, Cables& cables) {
  std::istringstream words(line);
  std::string command;
  size_t cable = 0, other = 0;
  double value = 0;
  words >> command;
  if (command == "bytes") return cables.bytesText();
  if (!(words >> cable) || cable >= cables.count()) return "error: no such cable: " + line;
  if (command == "cut" || command == "join") {
    const bool isPair = static_cast<bool>(words >> other);
    if (isPair && other >= cables.count()) return "error: no such cable: " + line;
    cables.setCut(cable, isPair ? other : cable, command == "cut");
    return "ok";
  }
  if (!(words >> value) || value < 0) return "error: no value: " + line;
  if (command == "delay")
    cables.at(cable).delayNs = static_cast<int64_t>(1000 * value);
  else if (command == "rate")
    cables.at(cable).bitsPerSecond = value;
  else if (command == "drop")
    cables.at(cable).lostShare = value;
  else
    return "error: unknown command: " + line;
  return "ok";
}

/// Commands, as far as they have come. False: standard input has ended.
bool obey(std::string& pending, Cables& cables) {
  char bytes[1024];
  const ssize_t got = read(STDIN_FILENO, bytes, sizeof bytes);
  if (got <= 0) return false;
  pending.append(bytes, static_cast<size_t>(got));
  for (size_t end; (end = pending.find('\n')) != std::string::npos; pending.erase(0, end + 1)) {
    std::printf("%s\n", answer(pending.substr(0, end), cables).c_str());
    std::fflush(stdout);
  }
  return true;
}

/// What hosts have sent.
void collect(size_t cable, const network::Taps& taps, Cables& cables) {
  for (int i = 0; i < kFramesInTurn && cables.takesFrom(cable, network::now()); ++i) {
    network::Bytes frame = cables.buffer(kLargestFrame);
    const ssize_t got = read(taps.at(cable), frame.data(), frame.size());
    if (got <= 0) return;
    frame.resize(static_cast<size_t>(got));
    cables.sent(cable, std::move(frame), network::now());
  }
}

void work(const network::Taps& taps, Cables& cables) {
  std::string pending;
  std::vector<pollfd> waits(taps.count() + 1);
  waits[taps.count()] = {STDIN_FILENO, POLLIN, 0};
  for (;;) {
    const auto deliver = [&](size_t to, const network::Bytes& frame) {
      return write(taps.at(to), frame.data(), frame.size()) >= 0;
    };
    cables.advance(network::now(), deliver);
    const int64_t start = network::now();
    for (size_t i = 0; i < taps.count(); ++i)
      waits[i] = {taps.at(i), static_cast<short>(cables.takesFrom(i, start) ? POLLIN : 0), 0};
    if (network::waitUntil(waits, cables.next(start)) < 0 && errno != EINTR) return;
    for (size_t i = 0; i < taps.count(); ++i)
      if (waits[i].revents & POLLIN) collect(i, taps, cables);
    if (waits[taps.count()].revents != 0 && !obey(pending, cables)) return;
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    prctl(PR_SET_TIMERSLACK, 1);  // ns
    // Networks do not wait for cores that programs use.
    sched_param first{};
    first.sched_priority = 1;
    sched_setscheduler(0, SCHED_RR, &first);
    const network::Taps taps(std::vector<std::string>(argv + 1, argv + argc));
    Cables cables(taps.count());
    std::printf("ready\n"), std::fflush(stdout);
    work(taps, cables);
  } catch (const std::exception& error) {
    std::printf("error: %s\n", error.what());
    return 1;
  }
  return 0;
}
