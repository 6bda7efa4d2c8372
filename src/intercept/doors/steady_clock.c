/* Deterministic clocks, random numbers and process id, so that two runs of a program draw equal frames.
   Preloaded by `gluray explain --html`, which compares a frame of one run with the same frame of another.
   Applies only to calls by the program itself, not by its libraries or GLuRay. Time advances by 40 ms per
   frame, when the engine reports the frame's end. From the hundredth query of a frame on, each query also
   advances it by 10 ms, so that programs that poll the clock do not wait for ever. libc only. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <link.h>
#include <stdint.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#define EXPORT __attribute__((visibility("default")))

enum { kStartSeconds = 1700000000, kFrameMs = 40, kFreeQuestions = 100, kQuestionMs = 10, kProcess = 4711 };

static uintptr_t programStart, programEnd;
static int64_t timeMs;
static int questions; /* queries in the current frame */

/* The first object reported is the program itself. */
static int findProgram(struct dl_phdr_info* info, size_t size, void* data) {
  (void)size;
  (void)data;
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    if (info->dlpi_phdr[i].p_type != PT_LOAD) continue;
    const uintptr_t start = info->dlpi_addr + info->dlpi_phdr[i].p_vaddr;
    if (!programStart) programStart = start;
    programEnd = start + info->dlpi_phdr[i].p_memsz;
  }
  return 1;
}

__attribute__((constructor)) static void start(void) { dl_iterate_phdr(findProgram, NULL); }

/* Called by the engine at the end of each frame. */
EXPORT void glurayFrameEnded(void);
void glurayFrameEnded(void) {
  __atomic_fetch_add(&timeMs, kFrameMs, __ATOMIC_RELAXED);
  __atomic_store_n(&questions, 0, __ATOMIC_RELAXED);
}

static int asksFor(const void* returnAddress) {
  const uintptr_t address = (uintptr_t)returnAddress;
  return address >= programStart && address < programEnd;
}

#define ASKED_BY_PROGRAM asksFor(__builtin_return_address(0))
#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

static struct timespec steadyTime(void) {
  if (__atomic_add_fetch(&questions, 1, __ATOMIC_RELAXED) > kFreeQuestions)
    __atomic_fetch_add(&timeMs, kQuestionMs, __ATOMIC_RELAXED);
  const int64_t ms = __atomic_load_n(&timeMs, __ATOMIC_RELAXED);
  const struct timespec now = {kStartSeconds + ms / 1000, ms % 1000 * 1000000};
  return now;
}

EXPORT int clock_gettime(clockid_t clock, struct timespec* now) {
  if (!ASKED_BY_PROGRAM) return REAL(clock_gettime)(clock, now);
  *now = steadyTime();
  return 0;
}

EXPORT int gettimeofday(struct timeval* restrict now, void* restrict zone) {
  if (!ASKED_BY_PROGRAM) return REAL(gettimeofday)(now, zone);
  const struct timespec steady = steadyTime();
  now->tv_sec = steady.tv_sec;
  now->tv_usec = steady.tv_nsec / 1000;
  return 0;
}

EXPORT time_t time(time_t* out) {
  if (!ASKED_BY_PROGRAM) return REAL(time)(out);
  const time_t now = steadyTime().tv_sec;
  if (out) *out = now;
  return now;
}

EXPORT pid_t getpid(void) { return ASKED_BY_PROGRAM ? kProcess : REAL(getpid)(); }

/* A separate random generator for the program, because libraries use the C library's generator at varying
   times. xorshift64, Marsaglia 2003. */
static uint64_t seed = 88172645463325252u;

static void reseed(unsigned value) { seed = 88172645463325252u ^ (uint64_t)value * 2654435761u; }

static long nextRandom(void) {
  seed ^= seed << 13;
  seed ^= seed >> 7;
  seed ^= seed << 17;
  return (long)(seed >> 33);
}

EXPORT int rand(void);
EXPORT long random(void);
EXPORT double drand48(void);
EXPORT void srand(unsigned value);
EXPORT void srandom(unsigned value);
EXPORT void srand48(long value);

int rand(void) { return ASKED_BY_PROGRAM ? (int)nextRandom() : REAL(rand)(); }
long random(void) { return ASKED_BY_PROGRAM ? nextRandom() : REAL(random)(); }
double drand48(void) { return ASKED_BY_PROGRAM ? (double)nextRandom() / 2147483648.0 : REAL(drand48)(); }

void srand(unsigned value) {
  if (!ASKED_BY_PROGRAM)
    REAL(srand)(value);
  else
    reseed(value);
}
void srandom(unsigned value) {
  if (!ASKED_BY_PROGRAM)
    REAL(srandom)(value);
  else
    reseed(value);
}
void srand48(long value) {
  if (!ASKED_BY_PROGRAM)
    REAL(srand48)(value);
  else
    reseed((unsigned)value);
}
