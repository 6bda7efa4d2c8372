#include "tests/fuzz/player.h"

#include <cstring>
#include <iterator>
#include <limits>

namespace gluray::fuzz {

Source::Source() {
  Random random(1);
  for (size_t i = 0; i + sizeof(float) <= bytes.size(); i += sizeof(float)) {
    const float value = static_cast<float>(random.below(2001)) / 1000 - 1;
    std::memcpy(&bytes[i], &value, sizeof value);
  }
  for (size_t i = 0; i < indices8.size(); ++i) {
    indices32[i] = random.below(kIndices);
    indices16[i] = static_cast<GLushort>(indices32[i]);
    indices8[i] = static_cast<GLubyte>(indices32[i]);
  }
}

const Source& source() {
  static const Source once;
  return once;
}

float Player::real() {
  using Limits = std::numeric_limits<float>;
  static constexpr float kAbsurd[] = {Limits::quiet_NaN(),
                                      Limits::infinity(),
                                      -Limits::infinity(),
                                      Limits::max(),
                                      Limits::denorm_min(),
                                      -0.0f,
                                      1e20f,
                                      -1e9f};
  if (chance(weird_)) return note(kAbsurd[random_.below(std::size(kAbsurd))]);
  if (chance(10)) return note(static_cast<float>(random_.below(7)) - 3);
  return note(static_cast<float>(random_.below(2001)) / 1000 - 1);
}

void Player::arraysToMemory() {
  const void* at = source().bytes.data();
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  gl.VertexPointer(3, GL_FLOAT, 0, at), gl.NormalPointer(GL_FLOAT, 0, at),
      gl.ColorPointer(4, GL_FLOAT, 0, at);
  gl.SecondaryColorPointer(3, GL_FLOAT, 0, at), gl.FogCoordPointer(GL_FLOAT, 0, at);
  gl.EdgeFlagPointer(0, at), gl.IndexPointer(GL_FLOAT, 0, at);
  for (GLenum unit : {GL_TEXTURE1, GL_TEXTURE0})
    gl.ClientActiveTexture(unit), gl.TexCoordPointer(2, GL_FLOAT, 0, at);
  for (GLuint i = 0; i < 4; ++i) gl.VertexAttribPointer(i, 4, GL_FLOAT, GL_FALSE, 0, at);
}

void Player::fillBuffers() {
  for (GLuint name = 1; name <= kVertexBuffers; ++name) {
    gl.BindBuffer(GL_ARRAY_BUFFER, name);
    gl.BufferData(GL_ARRAY_BUFFER, kWholeBuffer, source().bytes.data(), GL_STATIC_DRAW);
  }
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
}

GLint Player::integer() {
  static constexpr GLint kAbsurd[] = {std::numeric_limits<GLint>::max(), std::numeric_limits<GLint>::min(),
                                      -1, 65536};
  if (chance(weird_)) return note(kAbsurd[random_.below(std::size(kAbsurd))]);
  return note(static_cast<GLint>(random_.below(9)) - 2);
}

GLsizei Player::count(uint32_t most) {
  if (chance(weird_))
    return note(chance(50) ? -1 - static_cast<GLsizei>(random_.below(3)) : static_cast<GLsizei>(most) + 1);
  return note(static_cast<GLsizei>(random_.below(most + 1)));
}

GLenum Player::pick(std::initializer_list<GLenum> choices) {
  if (chance(weird_)) return note(static_cast<GLenum>(random_.below(0x9400)));
  return note(choices.begin()[random_.below(static_cast<uint32_t>(choices.size()))]);
}

GLuint Player::name(uint32_t most) {
  if (chance(weird_)) return note(chance(50) ? 0u : 100 + random_.below(3));
  return note(1 + random_.below(most));
}

}  // namespace gluray::fuzz
