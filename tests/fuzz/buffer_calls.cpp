#include "tests/fuzz/calls.h"

#include <algorithm>
#include <cstring>

namespace gluray::fuzz {
namespace {

GLenum bufferTarget(Player& p) {
  return p.pick({GL_ARRAY_BUFFER, GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER, GL_COPY_READ_BUFFER});
}
GLenum usage(Player& p) { return p.pick({GL_STATIC_DRAW, GL_DYNAMIC_DRAW, GL_STREAM_DRAW}); }

/// A size large enough for every draw, unless this stream tests draws that reach beyond their buffers.
GLsizei sizeOfData(Player& p) {
  const GLsizei size = p.smallBuffers ? p.count(4096) : Player::kWholeBuffer;
  return size == 0 ? 1 : size;  // avoided.md
}

void write(Player& p, void* mapped, size_t bytes) {
  if (mapped) std::memcpy(mapped, p.read(), bytes);
}

/// The mapped range may be smaller than the data.
void mapBuffer(Player& p) {
  const GLenum which = bufferTarget(p);
  const auto* data = p.read();
  p.gl.BindBuffer(which, p.name(kIndexBuffer));
  p.gl.BufferData(which, Player::kWholeBuffer, data, GL_STATIC_DRAW);
  write(p, p.gl.MapBuffer(which, p.pick({GL_WRITE_ONLY, GL_READ_WRITE})), 256);
}

void mapRange(Player& p) {
  const GLenum which = bufferTarget(p);
  const GLintptr offset = 16 * p.below(4);
  const GLsizeiptr length = 16 * static_cast<GLsizeiptr>(p.below(5));
  write(p,
        p.gl.MapBufferRange(which, offset, length, GL_MAP_WRITE_BIT | (p.chance(30) ? GL_MAP_READ_BIT : 0)),
        static_cast<size_t>(length));
}

const Op kBufferOps[] = {
    {"BindBuffer", 6,
     [](Player& p) {
       const GLenum which = bufferTarget(p);
       p.gl.BindBuffer(which, p.name(kIndexBuffer));
     }},
    {"unbind buffer", 4, [](Player& p) { p.gl.BindBuffer(bufferTarget(p), 0); }},
    {"BufferData", 10,
     [](Player& p) {
       const GLenum which = bufferTarget(p);
       const GLsizei size = sizeOfData(p);
       const auto* data = p.read();
       p.gl.BufferData(which, size, data, usage(p));
     }},
    {"BufferSubData", 6,
     [](Player& p) {
       const GLenum which = bufferTarget(p);
       const GLintptr offset = p.below(256);
       const GLsizei size = p.count(512);
       p.gl.BufferSubData(which, offset, size, p.read());
     }},
    {"MapBuffer", 2, mapBuffer},
    {"MapBufferRange", 3, mapRange},
    {"UnmapBuffer", 8,
     [](Player& p) { p.answer("UnmapBuffer", {static_cast<double>(p.gl.UnmapBuffer(bufferTarget(p)))}); }},
    {"CopyBufferSubData", 2,
     [](Player& p) {
       const GLintptr from = p.below(64), to = p.below(64);
       p.gl.CopyBufferSubData(GL_COPY_READ_BUFFER, GL_ARRAY_BUFFER, from, to, p.count(128));
     }},
    {"DeleteBuffers", 3,
     [](Player& p) {
       if (p.insideBegin) return;
       p.arraysToMemory();
       const GLuint name = p.name(kIndexBuffer);
       p.gl.DeleteBuffers(1, &name);
       p.fillBuffers();
     }},
    {"GetBufferSubData", 3,
     [](Player& p) {
       GLubyte got[64] = {};
       const GLenum which = bufferTarget(p);
       p.gl.GetBufferSubData(which, p.below(32), 64, got);
       double sum = 0;
       for (size_t i = 0; i < sizeof got; ++i) sum += got[i] * static_cast<double>(i + 1);
       p.answer("GetBufferSubData", {sum});
     }},
    {"GetBufferParameteriv", 3,
     [](Player& p) {
       GLint got = -5;
       const GLenum which = bufferTarget(p);
       p.gl.GetBufferParameteriv(
           which, p.pick({GL_BUFFER_SIZE, GL_BUFFER_USAGE, GL_BUFFER_MAPPED, GL_BUFFER_ACCESS}), &got);
       p.answer("GetBufferParameteriv", {static_cast<double>(got)});
     }},
    {"IsBuffer", 1,
     [](Player& p) { p.answer("IsBuffer", {static_cast<double>(p.gl.IsBuffer(p.name(kIndexBuffer)))}); }},
    {"GenBuffers", 1,
     [](Player& p) {
       GLuint made = 0;
       p.gl.GenBuffers(1, &made);
       p.gl.DeleteBuffers(1, &made);
     }},
};

}  // namespace

Ops bufferCalls() { return kBufferOps; }

}  // namespace gluray::fuzz
