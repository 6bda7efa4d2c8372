// Preloaded into a program under test so that two runs of it show the same frames. Clocks, random numbers and
// the process number give the program itself (not its libraries, nor GLuRay) the same values in both runs:
// time moves by 40 ms with every buffer swap. After swap number LIVE_FRAME the program waits until the file
// LIVE_GO exists, then ends; LIVE_READY is created when its image is in the window.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <fcntl.h>
#include <link.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

static uintptr_t g_programStart, g_programEnd;
static int g_swaps;

/// The first object reported is the program itself.
static int findProgram(struct dl_phdr_info* info, size_t size, void* data) {
  (void)size;
  (void)data;
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    if (info->dlpi_phdr[i].p_type != PT_LOAD) continue;
    const uintptr_t start = info->dlpi_addr + info->dlpi_phdr[i].p_vaddr;
    if (!g_programStart) g_programStart = start;
    g_programEnd = start + info->dlpi_phdr[i].p_memsz;
  }
  return 1;
}

__attribute__((constructor)) static void start(void) { dl_iterate_phdr(findProgram, NULL); }

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))
#define ASKED_BY_PROGRAM                                       \
  ((uintptr_t)__builtin_return_address(0) >= g_programStart && \
   (uintptr_t)__builtin_return_address(0) < g_programEnd)

enum { kStartSeconds = 1700000000, kFrameMs = 40 };

static struct timespec frozenTime(void) {
  const int64_t ms = (int64_t)g_swaps * kFrameMs;
  const struct timespec t = {kStartSeconds + ms / 1000, ms % 1000 * 1000000};
  return t;
}

int clock_gettime(clockid_t clock, struct timespec* t) {
  if (!ASKED_BY_PROGRAM) return REAL(clock_gettime)(clock, t);
  *t = frozenTime();
  return 0;
}

int gettimeofday(struct timeval* t, void* zone) {
  if (!ASKED_BY_PROGRAM) return REAL(gettimeofday)(t, zone);
  const struct timespec now = frozenTime();
  t->tv_sec = now.tv_sec;
  t->tv_usec = now.tv_nsec / 1000;
  return 0;
}

time_t time(time_t* out) {
  if (!ASKED_BY_PROGRAM) return REAL(time)(out);
  const time_t now = frozenTime().tv_sec;
  if (out) *out = now;
  return now;
}

pid_t getpid(void) { return ASKED_BY_PROGRAM ? 4711 : REAL(getpid)(); }

/// A separate generator for the program: libraries use the C library's at varying moments.
static long nextRandom(void) {
  static uint64_t state = 88172645463325252u;  // xorshift64 (Marsaglia 2003)
  state ^= state << 13;
  state ^= state >> 7;
  state ^= state << 17;
  return (long)(state >> 33);
}

int rand(void) { return ASKED_BY_PROGRAM ? (int)nextRandom() : REAL(rand)(); }
long random(void) { return ASKED_BY_PROGRAM ? nextRandom() : REAL(random)(); }
double drand48(void) { return ASKED_BY_PROGRAM ? (double)nextRandom() / 2147483648.0 : REAL(drand48)(); }

static void afterSwap(void) {
  const char *frame = getenv("LIVE_FRAME"), *ready = getenv("LIVE_READY"), *go = getenv("LIVE_GO");
  if (++g_swaps != (frame ? atoi(frame) : 0) || !ready || !go) return;
  close(open(ready, O_WRONLY | O_CREAT, 0644));
  while (access(go, F_OK) != 0) usleep(20000);
  exit(0);
}

struct Display;
void glXSwapBuffers(struct Display* display, unsigned long drawable) {
  REAL(glXSwapBuffers)(display, drawable);
  afterSwap();
}

unsigned eglSwapBuffers(void* display, void* surface) {
  const unsigned done = REAL(eglSwapBuffers)(display, surface);
  afterSwap();
  return done;
}
