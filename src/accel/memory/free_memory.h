// Free memory of the machine, control group and process. Any thread.
#pragma once
#include <cstddef>
#include <string_view>

namespace gluray::accel {

/// Bytes that can be allocated before the machine, the process's control group, or its own limits (ulimit -v,
/// -d) are exhausted; file caches count as free. SIZE_MAX where unknown. Takes about 0.1 ms.
size_t freeMemory() noexcept;

/// The number after `name` in lines of "NAME: NUMBER kB" or "NAME NUMBER"; `otherwise` if there is none.
size_t numberBehind(std::string_view text, std::string_view name, size_t otherwise);

}  // namespace gluray::accel
