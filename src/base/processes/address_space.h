/* How much address space the process's limits leave (ulimit -v, -d), and how much OpenGL and GLuRay need: if
   it runs out, the real OpenGL's compiler ends the program. C, for the doors, and C++. Any thread. */
#pragma once
#include <fcntl.h>
#include <limits.h>
#include <sched.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <unistd.h>

/* Address space of a thread: its stack, and 64 MB for an arena of malloc. */
enum { glurayThreadMegabytes = 8 + 64 + 16 };
/* Bytes for the engine: its libraries (60 MB), a tracing thread, a building thread, and their first data. */
static const unsigned long long glurayEngineBytes = 248ull << 20;
/* Bytes left to the program and the real OpenGL while an image is traced: for compiling shaders, for an
   arena. */
static const unsigned long long glurayFrameReserve = 384ull << 20;

/* Bytes that the limits of address space and data leave; ULLONG_MAX without limits. Without /proc, the lower
   limit itself. */
static inline unsigned long long glurayAddressSpaceLeft(void) {
  struct rlimit all, data;
  if (getrlimit(RLIMIT_AS, &all) != 0) all.rlim_cur = RLIM_INFINITY;
  if (getrlimit(RLIMIT_DATA, &data) != 0) data.rlim_cur = RLIM_INFINITY;
  if (all.rlim_cur == RLIM_INFINITY && data.rlim_cur == RLIM_INFINITY) return ULLONG_MAX;
  char text[256];
  const int file = open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
  const ssize_t length = file >= 0 ? read(file, text, sizeof text - 1) : -1;
  if (file >= 0) close(file);
  text[length > 0 ? length : 0] = 0;
  /* Pages: all, resident, shared, code, libraries, data and stack. */
  unsigned long long pages[6] = {0, 0, 0, 0, 0, 0};
  char* at = text;
  for (int i = 0; i < 6; ++i) pages[i] = strtoull(at, &at, 10);
  const unsigned long long page = (unsigned long long)sysconf(_SC_PAGESIZE);
  const unsigned long long used[2] = {pages[0] * page, pages[5] * page};
  const rlim_t limits[2] = {all.rlim_cur, data.rlim_cur};
  unsigned long long least = ULLONG_MAX;
  for (int i = 0; i < 2; ++i) {
    if (limits[i] == RLIM_INFINITY) continue;
    const unsigned long long left = limits[i] > used[i] ? limits[i] - used[i] : 0;
    if (left < least) least = left;
  }
  return least;
}

/* Bytes that the real OpenGL, whose libraries are loaded, needs from its first context to its first image.
   Mesa's software rasteriser starts a thread for each processor, at most 32, unless LP_NUM_THREADS sets the
   number. */
static inline unsigned long long glurayRealGlBytes(void) {
  const unsigned long long compiler = 240ull << 20;
  const char* chosen = getenv("LP_NUM_THREADS");
  cpu_set_t set;
  long threads =
      sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : sysconf(_SC_NPROCESSORS_ONLN);
  if (chosen && *chosen) threads = strtol(chosen, NULL, 10);
  if (threads < 0) threads = 0;
  if (threads > 32) threads = 32;
  return compiler + ((unsigned long long)(threads * glurayThreadMegabytes) << 20);
}

/* Reason why nothing is traced; the number is glurayLoadBytes() in MB. */
#define GLURAY_ADDRESS_SPACE_IS_SHORT \
  "limits of the process (ulimit -v, -d) leave less than the %llu MB that OpenGL and ray tracing need"

/* Bytes that must be left when the engine is loaded. */
static inline unsigned long long glurayLoadBytes(void) { return glurayEngineBytes + glurayRealGlBytes(); }
