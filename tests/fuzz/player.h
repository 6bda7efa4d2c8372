// Context for playing random calls: the OpenGL they go to, values drawn from the call's own seed, memory for
// pointers, and recorded results. A call depends only on its seed, not on the calls around
// it, so a stream stays valid when calls are removed.
#pragma once
#include "gl/real/real.h"
#include "tests/fuzz/random.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

namespace gluray::fuzz {

inline constexpr int kSize = 32;  // width and height of the framebuffer, pixels

inline constexpr GLuint kVertexBuffers = 5;  // names of buffers from 1 on that arrays may lie in
inline constexpr GLuint kIndexBuffer = 6;    // holds only indices when it is drawn from

/// Memory that calls read. Client arrays may use all of it: draws reach at most kReach bytes beyond a
/// pointer.
struct Source {
  static constexpr size_t kReach = 1 << 17;
  alignas(16) std::array<std::byte, 2 * kReach> bytes;  // floats from -1 to 1
  std::array<GLubyte, 256> indices8;                    // below kIndices
  std::array<GLushort, 256> indices16;
  std::array<GLuint, 256> indices32;
  static constexpr uint32_t kIndices = 200;
  Source();
};
const Source& source();

/// Memory that calls write: one for each of the two OpenGLs, alive as long as its contexts.
struct Sink {
  alignas(16) std::array<std::byte, 1 << 19> bytes{};
  std::array<GLuint, 512> selection{};
  std::array<GLfloat, 1024> feedback{};
};

/// The result of a query.
struct Answer {
  size_t call = 0;  // index in the stream
  std::string name;
  std::vector<double> values;
};

class Player {
 public:
  Player(const gl::RealGl& table, Sink& sink, std::function<void(uint32_t)> switchTo)
      : gl(table), sink_(sink), switchTo_(std::move(switchTo)) {}

  const gl::RealGl& gl;

  /// To be called before each call: the seed of its values, and the percentage of absurd ones.
  void start(size_t call, uint64_t seed, uint32_t weird) {
    call_ = call, random_ = Random(seed), weird_ = weird;
  }
  uint32_t below(uint32_t n) { return note(random_.below(n)); }
  bool chance(uint32_t percent) { return random_.chance(percent); }
  /// Mostly between -1 and 1, or small whole numbers; if absurd also infinite, huge or NaN.
  float real();
  template <size_t N>
  std::array<float, N> reals() {
    std::array<float, N> values;
    for (float& v : values) v = real();
    return values;
  }
  /// Small; if absurd anything.
  GLint integer();
  /// From 0 to `most`; if absurd also negative or slightly larger; never huge, which would keep Mesa busy.
  GLsizei count(uint32_t most);
  /// One of these; if absurd any enum.
  GLenum pick(std::initializer_list<GLenum> choices);
  GLboolean flag() { return below(2) ? GL_TRUE : GL_FALSE; }
  /// A bit pattern.
  uint32_t bits() { return note(static_cast<uint32_t>(random_.next())); }
  /// From 1 to `most`; if absurd also 0 and names that were never created.
  GLuint name(uint32_t most);

  /// Memory to read, aligned to 16 bytes, with kReach bytes behind it.
  const std::byte* read() { return &source().bytes[16 * below(64)]; }
  Sink& sink() { return sink_; }
  void switchTo(uint32_t which) { switchTo_(context = which); }

  void answer(std::string name, std::vector<double> values) {
    answers_.push_back({call_, std::move(name), std::move(values)});
  }
  const std::vector<Answer>& answers() const { return answers_; }
  /// Receives the drawn values as text.
  std::string* log = nullptr;

  /// Points every vertex array to memory, because pointers into a deleted buffer are invalid.
  void arraysToMemory();
  /// Makes every buffer large enough for every draw.
  void fillBuffers();
  static constexpr GLsizei kWholeBuffer = 1 << 14;
  /// Whether draws may reach beyond their buffers. Mesa checks that, except in lists and glArrayElement.
  bool smallBuffers = false;

  // State from earlier calls, to avoid calls that crash Mesa or take too long (see avoided.md).
  bool compiling = false, executing = false, insideBegin = false, listCalled = false;
  bool grown = false;  // the list has a primitive whose vertices have different attributes (avoided.md)
  bool vertexWanted = false;  // attributes were set inside glBegin since the last vertex
  int attributeSize = 4;      // components of texture coordinates and generic attributes
  int queriesActive = 0;
  uint32_t context = 0;                                 // which of the two is current
  std::array<GLuint, 3> programs{};                     // those made so far; 0: none yet
  std::array<std::array<GLuint, 3>, 2> vertexArrays{};  // of each context

 private:
  template <class T>
  T note(T value) {
    if (log) log->append(1, ' ').append(std::to_string(value));
    return value;
  }
  Sink& sink_;
  std::function<void(uint32_t)> switchTo_;
  Random random_{0};
  uint32_t weird_ = 0;
  size_t call_ = 0;
  std::vector<Answer> answers_;
};

}  // namespace gluray::fuzz
