// A random scene as a list of OpenGL calls, which can be played, printed and shortened.
#pragma once
#include "gl/real/real.h"
#include "tests/fuzz/scenes/dice.h"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace gluray::fuzz {

using Gl = const gl::RealGl&;
/// Values that a scene has queried.
using Answers = std::vector<float>;

/// What a call opens or closes. The shrinker keeps openers and closers in pairs.
enum class Role : uint8_t { other, vertex, begin, end, newList, endList, push, pop };

struct Call {
  Role role = Role::other;
  std::function<void(Gl, Answers&)> play;
  std::function<std::string()> text;
  size_t pair = 0;  // of an opener and its closer: a number that they share (isBalanced)
};

/// Memory of arrays and indices, which lives as long as the calls that refer to it.
using Bytes = std::shared_ptr<const std::vector<std::byte>>;

template <class T>
const T& passed(const T& value) {
  return value;
}
template <class T, size_t n>
const T* passed(const std::array<T, n>& values) {
  return values.data();
}

template <class T>
std::string printed(const T& value) {
  std::ostringstream out;
  out.precision(9);
  if constexpr (std::is_same_v<T, GLenum>) {
    if (value > 255) out << "0x" << std::hex;
  }
  out << +value;
  return out.str();
}
template <class T, size_t n>
std::string printed(const std::array<T, n>& values) {
  std::string text = "{";
  for (const T& value : values) text += (text.size() > 1 ? ", " : "") + printed(value);
  return text + "}";
}

/// A call of one function of the table.
template <auto function, class... Arguments>
Call callOf(const char* name, Role role, Arguments... arguments) {
  return {role, [=](Gl gl, Answers&) { (gl.*function)(passed(arguments)...); },
          [=] {
            std::string text;
            ((text += (text.empty() ? "" : ", ") + printed(arguments)), ...);
            return name + ("(" + text) + ")";
          }};
}

/// Appends calls to a scene, with values from its dice.
struct Writer {
  Dice& dice;
  std::vector<Call>& calls;
  // Whether light may be two-sided. Then no materials of back faces alone change, and none of one face alone
  // between glBegin and glEnd: avoided.md.
  bool twoSided = false;
  bool offsetsLines = false;  // the scene has enabled polygon offset of lines or points
  bool samePlace = false;     // a shape is drawn again at its place: clip planes stay (avoided.md)

  enum class At : uint8_t { outside, inside };  // glBegin and glEnd
  uint32_t face(At at = At::outside) {
    constexpr uint32_t kFront = 0x404, kBack = 0x405, kBoth = 0x408;  // GL_FRONT, GL_BACK, GL_FRONT_AND_BACK
    const bool both = twoSided && at == At::inside;
    return dice.pick({both ? kBoth : kFront, twoSided ? kBoth : kBack, kBoth});
  }
  template <auto function, class... Arguments>
  void call(const char* name, Role role, Arguments... arguments) {
    calls.push_back(callOf<function>(name, role, arguments...));
  }
  /// Makes one call of the last `count`, so that the shrinker keeps or leaves out all of them.
  void join(size_t count);
  void call(std::string text, std::function<void(Gl, Answers&)> play) {
    calls.push_back({Role::other, std::move(play), [text = std::move(text)] { return text; }});
  }
};

/// WRITE(w, Color3f, 1.0f, 0.0f, 0.0f) appends glColor3f(1, 0, 0).
#define WRITE(writer, name, ...) WRITE_AS(writer, other, name __VA_OPT__(, ) __VA_ARGS__)
/// The same for a call that has another role.
#define WRITE_AS(writer, role, name, ...) \
  (writer).call<&gl::RealGl::name>("gl" #name, Role::role __VA_OPT__(, ) __VA_ARGS__)

}  // namespace gluray::fuzz
