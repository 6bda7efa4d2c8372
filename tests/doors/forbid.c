/* Starts a program for which the kernel refuses some calls, as a sandbox does.

   forbid links|access COMMAND ARGUMENT...   links: readlink; access: access */
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

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const int links = !strcmp(argv[1], "links");
  const unsigned first = links ? __NR_readlinkat : __NR_faccessat,
                 second = links ? __NR_readlinkat : __NR_faccessat2;
#ifdef __NR_access
  const unsigned third = links ? __NR_readlink : __NR_access;
#else
  const unsigned third = first;
#endif
  struct sock_filter code[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, nr)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, first, 3, 0),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, second, 2, 0),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, third, 1, 0),
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
