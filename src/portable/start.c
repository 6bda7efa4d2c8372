// The entry point of programs that also run with C libraries before 2.34. Those leave the constructors of the
// program itself to a function that the start files of newer compilers no longer contain. Newer C libraries,
// asked for the old version of
// __libc_start_main (tools/older_c_library.py), call the function as well.
#ifndef __x86_64__
#error "only x86-64 has an entry point for older C libraries; build without GLURAY_PORTABLE"
#endif

typedef void (*Function)(int, char**, char**);
// Of the linker.
extern Function __init_array_start[] __attribute__((visibility("hidden")));
extern Function __init_array_end[] __attribute__((visibility("hidden")));

extern int main(int, char**, char**);
extern int __libc_start_main(int (*main)(int, char**, char**), int count, char** arguments, Function init,
                             void (*fini)(void), void (*rtldFini)(void), void* stackEnd);

static void construct(int count, char** arguments, char** environment) {
  for (Function* one = __init_array_start; one != __init_array_end; ++one)
    (*one)(count, arguments, environment);
}

/// `stack` is what the kernel left: the number of arguments, and the arguments. Destructors are the dynamic
/// linker's.
__attribute__((used, noreturn)) void glurayStartMain(long* stack, void (*rtldFini)(void)) {
  __libc_start_main(main, (int)stack[0], (char**)(stack + 1), construct, 0, rtldFini, stack);
  __builtin_unreachable();
}

__asm__(
    ".globl glurayStart\n"
    ".type glurayStart, @function\n"
    "glurayStart:\n"
    "  .cfi_startproc\n"
    "  .cfi_undefined rip\n"
    "  xor %ebp, %ebp\n"
    "  mov %rsp, %rdi\n"
    "  mov %rdx, %rsi\n"
    "  and $-16, %rsp\n"
    "  call glurayStartMain\n"
    "  hlt\n"
    "  .cfi_endproc\n");
