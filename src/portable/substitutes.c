// Functions that C libraries before 2.36 lack, for a tree that runs with them: see tools/older_c_library.py.
// The names end in _substitute, so that no program takes one for the C library's own.
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdint.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

// In a library of their own they are exported; in other libraries and programs they are hidden.
#ifdef GLURAY_EXPORTED
#define SUBSTITUTE __attribute__((visibility("default")))
#else
#define SUBSTITUTE __attribute__((visibility("hidden")))
#endif

/// Since 2.32. False where it is not known: atomic operations are then used where there is one thread, too.
SUBSTITUTE char __libc_single_threaded_substitute = 0;

/// Since 2.36. The kernel's random numbers cannot fail once they are there; without them it returns what the
/// clock says.
SUBSTITUTE uint32_t arc4random_substitute(void) {
  uint32_t value;
  while (getrandom(&value, sizeof value, 0) != sizeof value) {
    if (errno == EINTR) continue;
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint32_t)now.tv_nsec ^ (uint32_t)now.tv_sec << 20;
  }
  return value;
}

/// Since 2.30.
SUBSTITUTE pid_t gettid_substitute(void) { return (pid_t)syscall(SYS_gettid); }

/// Since 2.33; before, the headers had them inline. The kernel's struct stat is that of the C library on 64
/// bits.
SUBSTITUTE int fstatat_substitute(int folder, const char* path, struct stat* status, int flags) {
  return (int)syscall(SYS_newfstatat, folder, path, status, flags);
}
SUBSTITUTE int stat_substitute(const char* path, struct stat* status) {
  return fstatat_substitute(AT_FDCWD, path, status, 0);
}
SUBSTITUTE int lstat_substitute(const char* path, struct stat* status) {
  return fstatat_substitute(AT_FDCWD, path, status, AT_SYMLINK_NOFOLLOW);
}
SUBSTITUTE int fstat_substitute(int file, struct stat* status) {
  return (int)syscall(SYS_fstat, file, status);
}
SUBSTITUTE int stat64_substitute(const char* path, struct stat* status) {
  return stat_substitute(path, status);
}
SUBSTITUTE int lstat64_substitute(const char* path, struct stat* status) {
  return lstat_substitute(path, status);
}
SUBSTITUTE int fstat64_substitute(int file, struct stat* status) { return fstat_substitute(file, status); }

/// Since 2.30. Waits until the same moment on the clock of the condition variable, which is CLOCK_REALTIME.
/// May wake early, as any wait may, but not late by more than the clocks drift apart.
SUBSTITUTE int pthread_cond_clockwait_substitute(pthread_cond_t* condition, pthread_mutex_t* mutex,
                                                 clockid_t clock, const struct timespec* until) {
  if (clock == CLOCK_REALTIME) return pthread_cond_timedwait(condition, mutex, until);
  struct timespec now, moment;
  if (clock_gettime(clock, &now) != 0) return EINVAL;
  clock_gettime(CLOCK_REALTIME, &moment);
  const long second = 1000000000L;
  moment.tv_sec += until->tv_sec - now.tv_sec;
  moment.tv_nsec += until->tv_nsec - now.tv_nsec;
  if (moment.tv_nsec < 0) moment.tv_nsec += second, --moment.tv_sec;
  if (moment.tv_nsec >= second) moment.tv_nsec -= second, ++moment.tv_sec;
  return pthread_cond_timedwait(condition, mutex, &moment);
}
