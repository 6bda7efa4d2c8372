// Runs work that needs more stack than a program's threads may have. Any thread.
#pragma once
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>

namespace gluray {

/// Stack that onAmpleStack() provides, in bytes: more than tracing with all effects uses.
inline constexpr size_t kAmpleStack = size_t{512} << 10;

/// Bytes left on the calling thread's stack. 0 if the program has moved the thread to a stack of its own (a
/// coroutine); SIZE_MAX if unknown.
size_t stackLeft() noexcept;

/// Calls work(object) on a new thread and waits for it. Rethrows its exceptions; throws std::bad_alloc if no
/// thread can be started.
void callOnOwnStack(void (*work)(void* object), void* object);

/// Calls work() and returns its result: on the caller's thread if that has kAmpleStack left, otherwise on a
/// new thread while the caller waits, so `work` must not call OpenGL. Rethrows its exceptions; throws
/// std::bad_alloc.
template <class Work>
auto onAmpleStack(Work&& work) {
  using Result = std::invoke_result_t<Work&>;
  if (stackLeft() >= kAmpleStack) [[likely]]
    return static_cast<Result>(work());
  if constexpr (std::is_void_v<Result>) {
    callOnOwnStack([](void* object) { (*static_cast<std::remove_reference_t<Work>*>(object))(); },
                   const_cast<void*>(static_cast<const void*>(&work)));
  } else {
    std::optional<Result> result;
    auto kept = [&] { result.emplace(work()); };
    callOnOwnStack([](void* object) { (*static_cast<decltype(kept)*>(object))(); }, &kept);
    return std::move(*result);
  }
}

}  // namespace gluray
