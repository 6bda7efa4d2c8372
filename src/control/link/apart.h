// A thread with its own descriptor table, for the link to the hub. The host program may close any descriptor
// and reuse its number, and asio would then use the host's files as its own. With a separate table, the host
// sees none of the link's descriptors, and forked children inherit none.
#pragma once
#include <pthread.h>

#include <functional>

namespace gluray::control {

/// Runs `work` on such a thread, with the host's signals blocked, and tasks of inProcess() on the calling
/// thread. Returns when `work` has ended. If the system refuses separate descriptor tables, as some sandboxes
/// do, the thread uses the process's table. Returns false, without running `work`, if no thread can be
/// started.
bool runApart(const std::function<void()>& work);

/// Runs `task` on the thread that called runApart(), which has the process's descriptors; if called on any
/// other thread than that of runApart(), runs it at once. For tasks that may start threads, because threads
/// inherit the descriptor table. Returns when `task` has ended; rethrows its exceptions.
void inProcess(const std::function<void()>& task);

/// Interrupts threads of runApart() that wait for wakeDescriptor(). Sends a signal that is blocked in these
/// threads and has no handler. Any thread.
void wakeApart(pthread_t thread) noexcept;

/// A descriptor that becomes readable when the calling thread, one of runApart(), is woken; -1 if there is
/// none. It must not be read.
int wakeDescriptor() noexcept;

}  // namespace gluray::control
