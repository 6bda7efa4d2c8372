/* Writes to the standard streams, and to files that stay open, inside a host program. The host may close the
   descriptor and reuse its number, so each write first checks that the number still refers to the same file.
   A write never blocks on a pipe, socket or terminal, and its signals (SIGPIPE, SIGTTOU, SIGXFSZ) never reach
   the host. C, for the doors, and C++; libc only. Any thread. */
#pragma once
#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

/* The launcher passes the identities of standard output and standard error in this variable, as "DEVICE.INODE
   DEVICE.INODE" in hexadecimal; "-": closed. */
#define GLURAY_STREAMS "GLURAY_STREAMS"

/* A descriptor and the file that it refers to. */
typedef struct GlurayOutput {
  int descriptor; /* -1: none */
  unsigned long long device, inode;
} GlurayOutput;

static inline GlurayOutput glurayNoOutput(void) {
  const GlurayOutput none = {-1, 0, 0};
  return none;
}

/* The file that `descriptor` refers to now. */
static inline GlurayOutput glurayOutputOf(int descriptor) {
  struct stat status;
  const int before = errno;
  GlurayOutput output = glurayNoOutput();
  if (descriptor >= 0 && fstat(descriptor, &status) == 0) {
    output.descriptor = descriptor;
    output.device = (unsigned long long)status.st_dev;
    output.inode = (unsigned long long)status.st_ino;
  }
  errno = before;
  return output;
}

/* Whether the descriptor still refers to the same file. */
static inline int glurayIsSame(const GlurayOutput* output) {
  const GlurayOutput now = glurayOutputOf(output->descriptor);
  return now.descriptor >= 0 && now.device == output->device && now.inode == output->inode;
}

/* Standard output (1) or standard error (2) as the launcher passed it to the program. Without a launcher, the
   file that the number refers to now, unless it is a regular file: the host may have opened that. */
static inline GlurayOutput glurayStream(int number) {
  const char* text = getenv(GLURAY_STREAMS);
  GlurayOutput output = glurayOutputOf(number);
  if (!text) {
    struct stat status;
    const int before = errno;
    const int regular = output.descriptor < 0 || fstat(number, &status) != 0 || S_ISREG(status.st_mode);
    errno = before;
    return regular ? glurayNoOutput() : output;
  }
  const char* entry = number == STDOUT_FILENO ? text : strchr(text, ' ');
  output.descriptor = entry && sscanf(entry, " %llx.%llx", &output.device, &output.inode) == 2 ? number : -1;
  return output;
}

/* A second descriptor of a pipe or terminal, whose writes do not block; -1 if there can be none. The flag
   O_NONBLOCK of `descriptor` itself would affect all processes that share it. */
static inline int glurayReopened(const GlurayOutput* output) {
  char path[40];
  snprintf(path, sizeof path, "/proc/self/fd/%d", output->descriptor);
  const int again = open(path, O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (again < 0) return -1;
  const GlurayOutput opened = glurayOutputOf(again);
  if (opened.device == output->device && opened.inode == output->inode) return again;
  close(again);
  return -1;
}

/* Writes a part of `bytes` without blocking. Returns the same values as write(2). */
static inline ssize_t glurayWritePart(const GlurayOutput* output, const char* bytes, size_t length) {
  struct stat status;
  const int descriptor = output->descriptor;
  if (fstat(descriptor, &status) != 0) return -1;
  if (S_ISSOCK(status.st_mode)) return send(descriptor, bytes, length, MSG_DONTWAIT | MSG_NOSIGNAL);
  const int fifo = S_ISFIFO(status.st_mode);
  if (!fifo && !isatty(descriptor)) return write(descriptor, bytes, length);
  const int again = glurayReopened(output);
  if (again >= 0) {
    const ssize_t written = write(again, bytes, length);
    const int error = errno;
    close(again);
    errno = error;
    return written;
  }
  /* A pipe that is ready accepts PIPE_BUF bytes. */
  const size_t most = fifo ? PIPE_BUF : 64;
  struct pollfd ready = {descriptor, POLLOUT, 0};
  if (poll(&ready, 1, 0) <= 0) return errno = EAGAIN, -1;
  return write(descriptor, bytes, length < most ? length : most);
}

/* Removes a pending, blocked signal that this thread's write has caused. */
static inline void glurayDropSignal(int error, const sigset_t* pendingBefore) {
  const int number = error == EPIPE ? SIGPIPE : error == EFBIG ? SIGXFSZ : 0;
  const struct timespec now = {0, 0};
  sigset_t one;
  if (!number || sigismember(pendingBefore, number)) return;
  sigemptyset(&one);
  sigaddset(&one, number);
  while (sigtimedwait(&one, NULL, &now) < 0 && errno == EINTR) {}
}

/* Writes `bytes`, if the descriptor still refers to the same file. Waits at most `patienceMs` for a reader
   that does not read. Returns the number of bytes written. `*error`: 0, or why that is not all (EAGAIN: the
   reader is slow; EBADF: the descriptor is closed, or refers to another file). Preserves errno. */
static inline size_t glurayWrite(const GlurayOutput* output, const char* bytes, size_t length, int patienceMs,
                                 int* error) {
  const int errnoBefore = errno;
  size_t done = 0;
  sigset_t ours, before, pending;
  sigemptyset(&ours);
  sigaddset(&ours, SIGPIPE);
  sigaddset(&ours, SIGTTOU);
  sigaddset(&ours, SIGXFSZ);
  sigemptyset(&pending);
  pthread_sigmask(SIG_BLOCK, &ours, &before);
  sigpending(&pending);
  *error = 0;
  while (done < length && *error == 0) {
    if (!glurayIsSame(output)) {
      *error = EBADF;
      break;
    }
    const ssize_t written = glurayWritePart(output, bytes + done, length - done);
    if (written > 0) {
      done += (size_t)written;
    } else if (written == 0 || errno == EAGAIN || errno == EWOULDBLOCK) {
      struct pollfd ready = {output->descriptor, POLLOUT, 0};
      if (patienceMs <= 0 || poll(&ready, 1, patienceMs--) <= 0) *error = EAGAIN;
    } else if (errno != EINTR) {
      *error = errno == ENXIO ? EPIPE : errno; /* ENXIO: a pipe without readers cannot be reopened */
    }
  }
  glurayDropSignal(*error, &pending);
  pthread_sigmask(SIG_SETMASK, &before, NULL);
  errno = errnoBefore;
  return done;
}
