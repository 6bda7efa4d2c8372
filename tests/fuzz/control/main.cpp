// Plays random messages of the control protocol: control_fuzz [--messages N] [--seed N]. A failure names the
// seed of its session, which `control_fuzz --session SEED` repeats.
#include "tests/fuzz/control/messages.h"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>

namespace {

std::atomic<uint64_t> playing{0};

void nameSession(int signal) {
  char text[80];
  const int size = std::snprintf(text, sizeof text, "control fuzz: again with --session %llu\n",
                                 static_cast<unsigned long long>(playing.load()));
  if (write(STDERR_FILENO, text, static_cast<size_t>(size)) < 0) _exit(1);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

int main(int argc, char** argv) {
  uint64_t messages = 100000, seed = 1;
  bool single = false;
  for (int i = 1; i + 1 < argc; i += 2) {
    const uint64_t value = std::strtoull(argv[i + 1], nullptr, 10);
    if (!std::strcmp(argv[i], "--messages")) messages = value;
    if (!std::strcmp(argv[i], "--seed")) seed = value;
    if (!std::strcmp(argv[i], "--session")) seed = value, single = true;
  }
  std::signal(SIGABRT, nameSession);
  std::signal(SIGSEGV, nameSession);
  uint64_t played = 0;
  for (playing = seed; played == 0 || (!single && played < messages); ++playing)
    played += gluray::fuzz::playSession(playing);
  std::printf("control fuzz: %llu messages, no failure\n", static_cast<unsigned long long>(played));
}
