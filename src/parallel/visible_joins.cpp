// For the thread sanitizer alone. The end of a parallel algorithm orders what its tasks did before what the
// caller does next. TBB's headers count the tasks down, which the sanitizer sees; libtbb, which is not
// instrumented, reads the count. Without this file, a caller that uses its stack again seems to race with the
// tasks that have read variables there.
#ifdef __SANITIZE_THREAD__
#include <dlfcn.h>
#include <sanitizer/tsan_interface.h>
#include <tbb/parallel_for.h>

namespace tbb::detail::r1 {

// Takes the place of libtbb's function, which it calls, for all callers of this binary.
void execute_and_wait(d1::task& task, d1::task_group_context& taskContext, d1::wait_context& tasksLeft,
                      d1::task_group_context& waitContext) {
  using Function = void (*)(d1::task&, d1::task_group_context&, d1::wait_context&, d1::task_group_context&);
  static const auto real = reinterpret_cast<Function>(dlsym(
      RTLD_NEXT,
      "_ZN3tbb6detail2r116execute_and_waitERNS0_2d14taskERNS2_18task_group_contextERNS2_12wait_contextES6_"));
  real(task, taskContext, tasksLeft, waitContext);
  auto* const words = reinterpret_cast<char*>(&tasksLeft);
  for (size_t at = 0; at < sizeof(tasksLeft); at += sizeof(uint64_t)) __tsan_acquire(words + at);
}

}  // namespace tbb::detail::r1
#endif
