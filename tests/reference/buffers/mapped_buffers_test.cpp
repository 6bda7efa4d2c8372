// Commands on buffers that the program has mapped: their errors and the mappings' addresses.
#include "tests/support/osmesa_context.h"
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace gluray::test {
namespace {

using Gl = const gl::RealGl&;

constexpr GLsizeiptr kBytes = 4096;

struct Command {
  const char* name;
  void (*run)(Gl gl, GLuint buffer);
};
void PrintTo(const Command& c, std::ostream* out) { *out << c.name; }

void store(Gl gl, GLenum target, GLuint buffer) {
  gl.BindBuffer(target, buffer);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1), gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

/// They may not use mapped bytes; glNamedBufferData and glBufferData end mappings.
constexpr Command kCommands[] = {
    {"InvalidateBufferData", [](Gl gl, GLuint b) { gl.InvalidateBufferData(b); }},
    {"InvalidateBufferSubData", [](Gl gl, GLuint b) { gl.InvalidateBufferSubData(b, 128, 64); }},
    {"InvalidateBesideTheMapping", [](Gl gl, GLuint b) { gl.InvalidateBufferSubData(b, 1024, 64); }},
    {"ClearBufferData",
     [](Gl gl, GLuint) { gl.ClearBufferData(GL_ARRAY_BUFFER, GL_R8, GL_RED, GL_UNSIGNED_BYTE, nullptr); }},
    {"ClearNamedBufferData",
     [](Gl gl, GLuint b) { gl.ClearNamedBufferData(b, GL_R8, GL_RED, GL_UNSIGNED_BYTE, nullptr); }},
    {"NamedBufferSubData",
     [](Gl gl, GLuint b) { gl.NamedBufferSubData(b, 0, 64, std::array<char, 64>{}.data()); }},
    {"NamedBufferSubDataOfTheMapping",
     [](Gl gl, GLuint b) { gl.NamedBufferSubData(b, 128, 64, std::array<char, 64>{}.data()); }},
    {"BufferSubDataAfterClear",
     [](Gl gl, GLuint b) {
       gl.ClearNamedBufferSubData(b, GL_R8, 600, 100, GL_RED, GL_UNSIGNED_BYTE, nullptr);
       gl.BufferSubData(GL_ARRAY_BUFFER, 800, 64, std::array<char, 64>{}.data());
     }},
    {"BufferSubData",
     [](Gl gl, GLuint) { gl.BufferSubData(GL_ARRAY_BUFFER, 128, 64, std::array<char, 64>{}.data()); }},
    {"GetNamedBufferSubData",
     [](Gl gl, GLuint b) {
       std::array<char, 64> bytes{};
       gl.GetNamedBufferSubData(b, 128, 64, bytes.data());
     }},
    {"CopyNamedBufferSubData",
     [](Gl gl, GLuint b) {
       GLuint other = 0;
       gl.CreateBuffers(1, &other), gl.NamedBufferData(other, kBytes, nullptr, GL_STATIC_DRAW);
       gl.CopyNamedBufferSubData(b, other, 128, 0, 64);
     }},
    {"ReadPixels",
     [](Gl gl, GLuint b) {
       store(gl, GL_PIXEL_PACK_BUFFER, b);
       gl.ReadPixels(0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
     }},
    {"TexImage2D",
     [](Gl gl, GLuint b) {
       store(gl, GL_PIXEL_UNPACK_BUFFER, b);
       gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
     }},
    {"MapAgain", [](Gl gl, GLuint b) { gl.MapNamedBuffer(b, GL_READ_ONLY); }},
    {"NamedBufferData", [](Gl gl, GLuint b) { gl.NamedBufferData(b, kBytes, nullptr, GL_STATIC_DRAW); }},
    {"BufferData", [](Gl gl, GLuint) { gl.BufferData(GL_ARRAY_BUFFER, kBytes, nullptr, GL_STATIC_DRAW); }},
};

class MappedBuffers : public testing::TestWithParam<Command> {};

/// What a program sees of a command between mapping and unmapping: errors, and the contents afterwards.
struct Seen {
  std::vector<GLenum> errors;
  std::vector<GLint> answers;
  std::vector<uint8_t> contents;
  bool operator==(const Seen&) const = default;
};

Seen seenOf(Gl gl, const Command& command) {
  Seen seen;
  const auto error = [&] { seen.errors.push_back(gl.GetError()); };
  std::vector<uint8_t> bytes(kBytes, 7);
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, kBytes, bytes.data(), GL_STATIC_DRAW);
  auto* const mapped = static_cast<uint8_t*>(
      gl.MapBufferRange(GL_ARRAY_BUFFER, 64, 512, GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_RANGE_BIT));
  error();
  if (mapped) std::fill_n(mapped, 512, uint8_t{9});
  command.run(gl, buffer), error();
  GLint isMapped = 0;
  gl.GetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_MAPPED, &isMapped);
  seen.answers.push_back(isMapped);
  gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0), gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  seen.answers.push_back(gl.UnmapBuffer(GL_ARRAY_BUFFER)), error();
  gl.BufferSubData(GL_ARRAY_BUFFER, 2048, 16, bytes.data()), error();  // possible again
  if (isMapped) {                                                      // otherwise undefined
    gl.GetBufferSubData(GL_ARRAY_BUFFER, 0, kBytes, bytes.data()), error();
    seen.contents = bytes;
  }
  return seen;
}

TEST_P(MappedBuffers, RaiseTheErrorsOfTheRealOpenGl) {
  const Seen expected = seenOf(OsmesaContext::create({16, 16})->real(), GetParam());
  TracedContext ours({16, 16});
  const Seen got = seenOf(ours.gl(), GetParam());
  EXPECT_EQ(got.errors, expected.errors);
  EXPECT_EQ(got.answers, expected.answers);
  EXPECT_TRUE(got.contents == expected.contents);
}

INSTANTIATE_TEST_SUITE_P(Commands, MappedBuffers, testing::ValuesIn(kCommands));

/// Every combination of the bits of glMapBufferRange, in and out of the buffer's range.
TEST(MappedBuffersByAnyBits, RaiseTheErrorsOfTheRealOpenGl) {
  const auto errorsOf = [](Gl gl) {
    std::vector<GLenum> errors;
    GLuint buffer = 0;
    gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl.BufferData(GL_ARRAY_BUFFER, kBytes, nullptr, GL_STATIC_DRAW);
    for (GLbitfield access = 0; access < 1024; ++access)
      for (const auto& [offset, length] :
           {std::pair<GLintptr, GLsizeiptr>{0, 16}, {-1, 16}, {16, -1}, {0, 0}, {4090, 16}}) {
        const void* const mapped = gl.MapBufferRange(GL_ARRAY_BUFFER, offset, length, access);
        errors.push_back(gl.GetError());
        if (mapped) gl.UnmapBuffer(GL_ARRAY_BUFFER);
      }
    return errors;
  };
  const std::vector<GLenum> expected = errorsOf(OsmesaContext::create({16, 16})->real());
  TracedContext ours({16, 16});
  EXPECT_EQ(errorsOf(ours.gl()), expected);
}

/// The address of offset 0, had it been mapped, is a multiple of GL_MIN_MAP_BUFFER_ALIGNMENT.
TEST(MappedBuffersOfAnySize, AreAligned) {
  TracedContext ours({16, 16});
  Gl gl = ours.gl();
  GLint alignment = 0;
  gl.GetIntegerv(GL_MIN_MAP_BUFFER_ALIGNMENT, &alignment);
  ASSERT_GE(alignment, 64);
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  for (const GLsizeiptr size : {1, 40, 100, 4096, 70000, 3000000}) {
    gl.BufferData(GL_ARRAY_BUFFER, size, nullptr, GL_STREAM_DRAW);
    for (const GLintptr offset : {GLintptr{0}, GLintptr{size / 3}}) {
      const auto at = reinterpret_cast<uintptr_t>(gl.MapBufferRange(
          GL_ARRAY_BUFFER, offset, size - offset, GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT));
      EXPECT_EQ((at - static_cast<uintptr_t>(offset)) % static_cast<uintptr_t>(alignment), 0u) << size;
      gl.UnmapBuffer(GL_ARRAY_BUFFER);
    }
  }
}

}  // namespace
}  // namespace gluray::test
