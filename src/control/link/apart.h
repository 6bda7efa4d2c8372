// A thread with a descriptor table of its own, for the link to the hub: the host program may close any
// descriptor and reuse its number, and asio would then use the host's files as its own. The host sees none of
// the link's descriptors, and children of a fork inherit none.
#pragma once
#include <pthread.h>

#include <functional>

namespace gluray::control {

/// Runs `work` on such a thread, with the host's signals blocked, and what it hands to inProcess() on the
/// calling thread. Returns when `work` has ended. Where the system refuses descriptor tables, as some
/// sandboxes do, the thread uses that of the process. False: no thread can be started, and `work` was not
/// run.
bool runApart(const std::function<void()>& work);

/// Runs `task` on the thread that called runApart(), whose descriptors are the process's; on any other thread
/// than that of runApart(): at once. For tasks that may start threads: these inherit the descriptor table.
/// Returns when `task` has ended; rethrows what it throws.
void inProcess(const std::function<void()>& task);

/// Interrupts threads of runApart() that wait for wakeDescriptor(). Sends a signal that is blocked there, and
/// that nobody handles. Any thread.
void wakeApart(pthread_t thread) noexcept;

/// A descriptor that becomes readable when the calling thread, one of runApart(), is woken; -1: there is
/// none. It must not be read.
int wakeDescriptor() noexcept;

}  // namespace gluray::control
