// gluray-bench-link: what messages between two ranks cost, as parameters of LogGP (Alexandrov, Ionescu,
// Schauser, Scheiman 1995), and how long a worker's main thread sleeps. Started by MPI's launcher as two
// ranks. One line a figure.
#include "mpi_choice.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <thread>
#include <vector>

namespace {

using namespace gluray;
using Clock = std::chrono::steady_clock;

constexpr int kRounds = 2000;
constexpr size_t kSmall = 64, kLarge = size_t{1} << 20;

/// The twentieth part of the times is shorter: what other processes of the machine did not disturb.
double usual(std::vector<double> times) {
  const auto at = times.begin() + static_cast<ptrdiff_t>(times.size() / 20);
  std::ranges::nth_element(times, at);
  return *at;
}

double microseconds(Clock::time_point since) {
  return std::chrono::duration<double, std::micro>(Clock::now() - since).count();
}

/// Without a call of MPI.
void spin(double forMicroseconds) {
  const auto start = Clock::now();
  while (microseconds(start) < forMicroseconds) {}
}

void receive(cluster::Ranks& ranks) {
  while (!ranks.receive()) ranks.progress();
}

/// Half the time of a message there and back: L + 2o of small ones. Both ranks call it.
double halfRoundTrip(cluster::Ranks& ranks, size_t bytes, int rounds) {
  std::vector<double> times;
  for (int i = 0; i < rounds; ++i) {
    const auto start = Clock::now();
    if (ranks.rank() == 0) ranks.send(1, std::vector<std::byte>(bytes));
    receive(ranks);
    if (ranks.rank() == 1) ranks.send(0, std::vector<std::byte>(bytes));
    times.push_back(microseconds(start) / 2);
  }
  while (ranks.busy()) ranks.progress();
  return usual(times);
}

/// The calls' own time: o of the sender and of the receiver.
struct Overheads {
  double send = 0, receive = 0;
};
Overheads overheads(cluster::Ranks& ranks, size_t bytes, int rounds) {
  std::vector<double> sends, receives;
  for (int i = 0; i < rounds; ++i) {
    std::vector<std::byte> message(bytes);
    if (ranks.rank() == 1) receive(ranks), spin(20);
    auto start = Clock::now();
    ranks.send(1 - ranks.rank(), std::move(message));
    sends.push_back(microseconds(start));
    if (ranks.rank() == 1) continue;
    spin(100);  // the answer is there by then, unless the other rank has no core
    start = Clock::now();
    receive(ranks);
    receives.push_back(microseconds(start));
  }
  while (ranks.busy()) ranks.progress();
  // Rank 1 measures no receives.
  return {usual(sends), ranks.rank() == 0 ? usual(receives) : 0};
}

/// Time between messages of a stream: g.
double gap(cluster::Ranks& ranks, size_t bytes) {
  constexpr int kStream = 1000;
  std::vector<double> times;
  for (int round = 0; round < 20; ++round) {
    const auto start = Clock::now();
    for (int i = 0; i < kStream; ++i)
      if (ranks.rank() == 0)
        ranks.send(1, std::vector<std::byte>(bytes)), ranks.progress();
      else
        receive(ranks);
    if (ranks.rank() == 1) ranks.send(0, std::vector<std::byte>(1));
    if (ranks.rank() == 0) receive(ranks);
    times.push_back(microseconds(start) / kStream);
  }
  while (ranks.busy()) ranks.progress();
  return usual(times);
}

/// How long the sleep of cluster::Worker's loop takes, which lasts 50 microseconds by its argument.
double sleepTime() {
  std::vector<double> times;
  for (int i = 0; i < kRounds; ++i) {
    const timespec longest{0, 50'000};
    const auto start = Clock::now();
    ppoll(nullptr, 0, &longest, nullptr);
    times.push_back(microseconds(start));
  }
  return usual(times);
}

/// From a write of an event by one thread until another that waits for it has read it.
double wakeTime() {
  const int event = eventfd(0, EFD_CLOEXEC);
  Clock::time_point written;
  std::vector<double> times;
  for (int i = 0; i < 500; ++i) {
    std::thread writer([&] {
      spin(200);
      written = Clock::now();
      eventfd_write(event, 1);
    });
    eventfd_t value = 0;
    eventfd_read(event, &value);
    times.push_back(microseconds(written));
    writer.join();
  }
  close(event);
  return usual(times);
}

void run(cluster::Ranks& ranks, double sleeps, double wakes) {
  halfRoundTrip(ranks, kSmall, 200);
  const double small = halfRoundTrip(ranks, kSmall, kRounds);
  const double large = halfRoundTrip(ranks, kLarge, kRounds / 10);
  const Overheads own = overheads(ranks, kSmall, kRounds);
  const double between = gap(ranks, kSmall);
  if (ranks.rank() != 0) return;
  std::printf("half_round_trip_us %.4f\nhalf_round_trip_1mib_us %.4f\n", small, large);
  std::printf("send_us %.4f\nreceive_us %.4f\ngap_us %.4f\n", own.send, own.receive, between);
  std::printf("gap_per_byte_ns %.5f\n", 1000 * (large - small) / static_cast<double>(kLarge - kSmall));
  std::printf("sleep_us %.3f\nwake_us %.3f\n", sleeps, wakes);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return std::fprintf(stderr, "usage: mpirun -n 2 gluray-bench-link MPI_LIBRARY\n"), 2;
  try {
    std::string why;
    const double sleeps = sleepTime(), wakes = wakeTime();  // before MPI, which may spin
    const std::unique_ptr<cluster::Ranks> ranks = worker::startRanks(argv[1], &argc, &argv, why);
    if (!ranks || ranks->size() != 2) throw std::runtime_error(ranks ? "it takes two ranks" : why);
    run(*ranks, sleeps, wakes);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gluray-bench-link: %s\n", error.what());
    return 1;
  }
}
