// How much memory the process may still take. Any thread.
#pragma once
#include <cstddef>
#include <string_view>

namespace gluray::accel {

/// Bytes that can be allocated before the machine, the control group that the process runs in, or the process
/// by its own limits (ulimit -v, -d) is out of memory; caches of files count as free. The largest number
/// where the system does not say. Never throws.
size_t freeMemory() noexcept;

/// The number behind `name` in lines of "NAME: NUMBER kB" or "NAME NUMBER"; `otherwise` where there is none.
size_t numberBehind(std::string_view text, std::string_view name, size_t otherwise);

}  // namespace gluray::accel
