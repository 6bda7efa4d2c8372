/* Starts a program for which the kernel refuses some calls, as a sandbox does.

   forbid links|access|tables COMMAND ARGUMENT...   links: readlink; access: access; tables: descriptor tables
                                                    of threads */
#include <errno.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#ifndef __NR_faccessat2
#define __NR_faccessat2 439
#endif
#ifndef __NR_close_range
#define __NR_close_range 436
#endif
/* Machines that only have the calls that take directories. */
#ifndef __NR_readlink
#define __NR_readlink __NR_readlinkat
#endif
#ifndef __NR_access
#define __NR_access __NR_faccessat
#endif

static const struct {
  const char* name;
  unsigned calls[3];
} kinds[] = {{"links", {__NR_readlink, __NR_readlinkat, __NR_readlinkat}},
             {"access", {__NR_access, __NR_faccessat, __NR_faccessat2}},
             {"tables", {__NR_unshare, __NR_close_range, __NR_close_range}}};

int main(int argc, char** argv) {
  size_t kind = 0;
  while (argc > 2 && kind < sizeof kinds / sizeof *kinds && strcmp(argv[1], kinds[kind].name)) ++kind;
  if (argc < 3 || kind == sizeof kinds / sizeof *kinds) return 2;
  const unsigned* const calls = kinds[kind].calls;
  struct sock_filter code[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, nr)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, calls[0], 3, 0),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, calls[1], 2, 0),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, calls[2], 1, 0),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM),
  };
  const struct sock_fprog program = {sizeof code / sizeof *code, code};
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return 77;
  if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0) return 77;
  execv(argv[2], argv + 2);
  perror("forbid");
  return 126;
}
