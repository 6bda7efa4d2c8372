// What a random call is made of: the OpenGL it goes to, values drawn from its own seed, memory that its
// pointers may point at, and the answers it got. The same seed means the same call whatever calls surround
// it, so that a stream stays valid when calls are taken out of it.
#pragma once
#include "gl/real.h"
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
inline constexpr GLuint kIndexBuffer = 6;    // the one that holds nothing but indices when it is drawn from

/// Memory that calls read. Client arrays may run over all of it: draws reach at most kReach bytes behind a
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

/// Memory that calls write: one of each side, alive as long as its contexts.
struct Sink {
  alignas(16) std::array<std::byte, 1 << 19> bytes{};
  std::array<GLuint, 512> selection{};
  std::array<GLfloat, 1024> feedback{};
};

/// What OpenGL said to a question.
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

  /// Before each call: where its values come from, and how many percent of them are absurd.
  void start(size_t call, uint64_t seed, uint32_t weird) {
    call_ = call, random_ = Random(seed), weird_ = weird;
  }
  uint32_t below(uint32_t n) { return note(random_.below(n)); }
  bool chance(uint32_t percent) { return random_.chance(percent); }
  /// Mostly between -1 and 1; small whole numbers; where absurd also infinite, huge or not a number.
  float real();
  template <size_t N>
  std::array<float, N> reals() {
    std::array<float, N> values;
    for (float& v : values) v = real();
    return values;
  }
  /// Small, where absurd anything.
  GLint integer();
  /// From 0 to `most`, where absurd also negative or a little above; never huge, because Mesa would work on
  /// it.
  GLsizei count(uint32_t most);
  /// One of these, where absurd any enum.
  GLenum pick(std::initializer_list<GLenum> choices);
  GLboolean flag() { return below(2) ? GL_TRUE : GL_FALSE; }
  /// A bit pattern.
  uint32_t bits() { return note(static_cast<uint32_t>(random_.next())); }
  /// From 1 to `most`; where absurd also 0 and names that nobody made.
  GLuint name(uint32_t most);

  /// Memory to read, aligned to 16 bytes, with kReach bytes behind it.
  const std::byte* read() { return &source().bytes[16 * below(64)]; }
  Sink& sink() { return sink_; }
  void switchTo(uint32_t which) { switchTo_(context = which); }

  void answer(std::string name, std::vector<double> values) {
    answers_.push_back({call_, std::move(name), std::move(values)});
  }
  const std::vector<Answer>& answers() const { return answers_; }
  /// Where the values drawn are written to, for people.
  std::string* log = nullptr;

  /// Every vertex array into memory: what points into a buffer that is deleted points at nothing.
  void arraysToMemory();
  /// Every buffer large enough for every draw.
  void fillBuffers();
  static constexpr GLsizei kWholeBuffer = 1 << 14;
  /// Whether draws may reach beyond their buffers. Mesa checks that, except in lists and glArrayElement.
  bool smallBuffers = false;

  // What a call must know of those before it, so that neither Mesa nor time runs out (see avoided.h).
  bool compiling = false, executing = false, insideBegin = false, listCalled = false;
  bool grown = false;  // the list has a primitive whose vertices are not all made of the same (avoided.md)
  bool vertexWanted = false;  // since the last one attributes were set inside glBegin
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
