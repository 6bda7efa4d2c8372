// Helpers of the generated stubs: conversions of vertex attributes (GL 2.1, table 2.9) and copies of arrays
// passed by pointer, for display lists. Included by generated code and its test.
#pragma once
#include "gl/capture/vertex_attribute_calls.h"
#include "gl/commands/finished_read.h"
#include "gl/context/handlers.h"
#include "gl/context/param_counts.h"
#include "gl/context/stub.h"
#include "intercept/stubs/orphan_gl.h"
#include "intercept/stubs/packed_attributes.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <vector>

namespace gluray::intercept::stubs {

/// An integer mapped to [0, 1] (unsigned) or [-1, 1] (signed: (2c + 1) / (2^b - 1)).
template <class Integer>
constexpr float normalised(Integer c) {
  constexpr double steps = static_cast<double>(std::numeric_limits<std::make_unsigned_t<Integer>>::max());
  if constexpr (std::is_signed_v<Integer>)
    return static_cast<float>((2.0 * c + 1.0) / steps);
  else
    return static_cast<float>(c / steps);
}

/// The rules of the current context; without one, those of the oldest version.
inline PackedRules packedRulesOfNow() {
  if (!gl::t_thread.context) return {};
  const gl::ContextInfo& info = gl::t_thread.context->shadow.info;
  return packedRules(info.version, info.packedFloats);
}

/// Owns a copy of an array that the program passed, for use after the call. Null stays null.
template <class T>
struct Copy {
  std::vector<T> values;
  bool null = false;
  const T* get() const { return null ? nullptr : values.data(); }
};

template <class T>
Copy<T> copyOf(const T* source, ptrdiff_t count) {
  if (!source) return {{}, true};
  return {std::vector<T>(source, source + (count > 0 ? count : 0)), false};
}

/// A copy of untyped memory.
struct CopyBytes {
  std::vector<std::byte> values;
  bool null = false;
  const void* get() const { return null ? nullptr : values.data(); }
};

inline CopyBytes copyOf(const void* source, ptrdiff_t bytes) {
  if (!source) return {{}, true};
  const auto* first = static_cast<const std::byte*>(source);
  return {std::vector<std::byte>(first, first + (bytes > 0 ? bytes : 0)), false};
}

}  // namespace gluray::intercept::stubs
