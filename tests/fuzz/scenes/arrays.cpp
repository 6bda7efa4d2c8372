#include "tests/fuzz/scenes/arrays.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace gluray::fuzz {
namespace {

/// One array: where its elements lie in the memory of all.
struct ArrayLayout {
  bool enabled = false;
  GLint size = 3;
  GLenum type = GL_FLOAT;
  GLsizei stride = 0;  // as given to OpenGL; 0: tightly packed
  size_t offset = 0;

  size_t component() const {
    switch (type) {
      case GL_DOUBLE: return 8;
      case GL_FLOAT:
      case GL_INT:
      case GL_UNSIGNED_INT: return 4;
      case GL_SHORT:
      case GL_UNSIGNED_SHORT: return 2;
      default: return 1;
    }
  }
  size_t bytes() const { return component() * static_cast<size_t>(size); }
  size_t step() const { return stride ? static_cast<size_t>(stride) : bytes(); }
};

template <class T>
void put(std::byte* to, double value) {
  const T stored = static_cast<T>(value);
  std::memcpy(to, &stored, sizeof stored);
}

/// `value`: fractions from -1 to 1 where the type is an integer.
void encode(std::byte* to, GLenum type, double value) {
  switch (type) {
    case GL_DOUBLE: return put<double>(to, value);
    case GL_SHORT: return put<GLshort>(to, std::round(value * 32767));
    case GL_BYTE: return put<GLbyte>(to, std::round(value * 127));
    case GL_UNSIGNED_BYTE: return put<GLubyte>(to, std::round(value * 255));
    case GL_UNSIGNED_SHORT: return put<GLushort>(to, std::round(value * 65535));
    case GL_INT: return put<GLint>(to, std::round(value));
    default: return put<float>(to, value);
  }
}
/// How a draw is made.
struct Plan {
  ArrayLayout vertex, normal, color, texcoord;
  Bytes memory, numbers;
  bool inBuffers = false, numbersInBuffer = false, interleaved = false;
  GLenum interleavedFormat = GL_N3F_V3F, numberType = 0;  // 0: vertices in order
  GLint first = 0;
  GLsizei count = 0;
  uint32_t elements = 0;
  uint32_t pieces = 1;  // of glMultiDraw*
  bool multi = false, range = false;
};

const ArrayLayout* layouts(const Plan& plan, size_t i) {
  const ArrayLayout* all[] = {&plan.vertex, &plan.normal, &plan.color, &plan.texcoord};
  return all[i];
}

void chooseTypes(Dice& dice, const Attributes& attributes, Plan& plan) {
  plan.vertex = {true, dice.chance(85) ? 3 : 4, dice.pick({GL_FLOAT, GL_FLOAT, GL_FLOAT, GL_DOUBLE})};
  plan.normal = {attributes.normals, 3, dice.pick({GL_FLOAT, GL_FLOAT, GL_DOUBLE, GL_SHORT, GL_BYTE})};
  plan.color = {attributes.colors, dice.chance(60) ? 4 : 3,
                dice.pick({GL_FLOAT, GL_FLOAT, GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_DOUBLE})};
  plan.texcoord = {attributes.texcoords, dice.chance(80) ? 2 : 3, dice.pick({GL_FLOAT, GL_FLOAT, GL_DOUBLE})};
}

/// Interleaved with padding, or one array behind the other. Returns the size of the memory.
size_t placeArrays(Dice& dice, Plan& plan) {
  ArrayLayout* all[] = {&plan.vertex, &plan.normal, &plan.color, &plan.texcoord};
  size_t at = dice.chance(50) ? 0 : 8 * (1 + dice.below(8));
  const size_t begin = at;
  const bool together = dice.chance(50);
  size_t stride = 0;
  for (ArrayLayout* a : all) {
    if (!a->enabled) continue;
    a->offset = together ? at + stride : at;
    const size_t size = (a->bytes() + 3) / 4 * 4;
    stride += size;
    if (together) continue;
    if (dice.chance(30)) a->stride = static_cast<GLsizei>(size + 4 * dice.below(3));
    at += (a->step() * plan.elements + 7) / 8 * 8;
  }
  if (!together) return at;
  stride += 4 * dice.below(3);
  for (ArrayLayout* a : all) a->stride = static_cast<GLsizei>(stride);
  return begin + stride * plan.elements;
}

/// One of the fixed formats of glInterleavedArrays.
void interleave(Dice& dice, Attributes& attributes, Plan& plan) {
  plan.interleaved = true;
  const uint32_t kind = dice.below(4);
  attributes = {kind != 0, kind == 0 || kind == 3, kind >= 2};
  // N3F, or C3F, or T2F and N3F, or T2F, C4F and N3F, each before V3F.
  plan.interleavedFormat = kind == 0   ? GL_C3F_V3F
                           : kind == 1 ? GL_N3F_V3F
                           : kind == 2 ? GL_T2F_N3F_V3F
                                       : GL_T2F_C4F_N3F_V3F;
  size_t at = 0;
  const auto place = [&](ArrayLayout& a, bool enabled, GLint size) {
    a = {enabled, size, GL_FLOAT, 0, at};
    if (enabled) at += a.bytes();
  };
  place(plan.texcoord, attributes.texcoords, 2), place(plan.color, attributes.colors, kind == 3 ? 4 : 3);
  place(plan.normal, attributes.normals, 3), place(plan.vertex, true, 3);
  for (ArrayLayout* a : {&plan.vertex, &plan.normal, &plan.color, &plan.texcoord})
    a->stride = static_cast<GLsizei>(at);
}

void fill(const Shape& shape, const std::vector<uint32_t>& order, Plan& plan, size_t bytes) {
  auto memory = std::make_shared<std::vector<std::byte>>(bytes);
  const auto store = [&](const ArrayLayout& a, size_t element, const float* values, int known) {
    std::byte* to = memory->data() + a.offset + element * a.step();
    for (int k = 0; a.enabled && k < a.size; ++k)
      encode(to + static_cast<size_t>(k) * a.component(), a.type, k < known ? values[k] : k == 3 ? 1 : 0);
  };
  const auto first = static_cast<size_t>(plan.first);
  for (size_t i = 0; i < order.size(); ++i) {
    const Corner& c = shape.corners[order[i]];
    store(plan.vertex, first + i, c.position.data(), 3), store(plan.normal, first + i, c.normal.data(), 3);
    store(plan.color, first + i, c.color.data(), 4), store(plan.texcoord, first + i, c.texcoord.data(), 2);
  }
  plan.memory = memory;
}

void fillNumbers(const std::vector<uint32_t>& triangles, Plan& plan) {
  const size_t size = plan.numberType == GL_UNSIGNED_INT ? 4 : plan.numberType == GL_UNSIGNED_SHORT ? 2 : 1;
  auto numbers = std::make_shared<std::vector<std::byte>>(triangles.size() * size);
  for (size_t i = 0; i < triangles.size(); ++i)
    std::memcpy(numbers->data() + i * size, &triangles[i], size);  // little-endian
  plan.numbers = numbers;
}

Plan makePlan(Writer& w, const Shape& shape, Attributes& attributes) {
  Dice& dice = w.dice;
  Plan plan;
  std::vector<uint32_t> triangles = trianglesOf(shape);
  chooseTypes(dice, attributes, plan);
  std::vector<uint32_t> order = triangles;
  if (dice.chance(55)) {
    plan.numberType = shape.corners.size() > 255 || dice.chance(70)
                          ? dice.pick({GL_UNSIGNED_SHORT, GL_UNSIGNED_INT, GL_UNSIGNED_INT})
                          : GLenum{GL_UNSIGNED_BYTE};
    order.resize(shape.corners.size());
    for (uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  } else {
    plan.first = dice.chance(60) ? 0 : static_cast<GLint>(dice.below(12));
  }
  plan.count = static_cast<GLsizei>(triangles.size());
  plan.elements = static_cast<uint32_t>(order.size()) + static_cast<uint32_t>(plan.first);
  size_t bytes = 0;
  if (dice.chance(15)) {
    interleave(dice, attributes, plan);
    bytes = static_cast<size_t>(plan.vertex.stride) * plan.elements;
  } else {
    bytes = placeArrays(dice, plan);
  }
  plan.inBuffers = dice.chance(50);
  plan.numbersInBuffer = plan.numberType && dice.chance(50);
  plan.multi = dice.chance(15) && !w.offsetsLines, plan.range = dice.chance(30);
  // None without vertices: avoided.md.
  plan.pieces = plan.multi ? 1 + dice.below(std::min<uint32_t>(4, triangles.size() / 3)) : 1;
  fill(shape, order, plan, bytes);
  if (plan.numberType) fillNumbers(triangles, plan);
  return plan;
}

void bindBufferWith(Gl gl, GLenum target, const Bytes& bytes) {
  GLuint name = 0;
  gl.GenBuffers(1, &name), gl.BindBuffer(target, name);
  gl.BufferData(target, static_cast<GLsizeiptr>(bytes->size()), bytes->data(), GL_STATIC_DRAW);
}

void setArrays(Gl gl, const Plan& plan, const std::byte* base) {
  if (plan.interleaved) return gl.InterleavedArrays(plan.interleavedFormat, 0, base);
  constexpr GLenum kArrays[] = {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY};
  for (size_t i = 0; i < 4; ++i)
    if (layouts(plan, i)->enabled) gl.EnableClientState(kArrays[i]);
  const auto at = [&](const ArrayLayout& a) {
    return reinterpret_cast<const void*>(reinterpret_cast<uintptr_t>(base) + a.offset);
  };
  gl.VertexPointer(plan.vertex.size, plan.vertex.type, plan.vertex.stride, at(plan.vertex));
  if (plan.normal.enabled) gl.NormalPointer(plan.normal.type, plan.normal.stride, at(plan.normal));
  if (plan.color.enabled)
    gl.ColorPointer(plan.color.size, plan.color.type, plan.color.stride, at(plan.color));
  if (plan.texcoord.enabled)
    gl.TexCoordPointer(plan.texcoord.size, plan.texcoord.type, plan.texcoord.stride, at(plan.texcoord));
}

void dropArrays(Gl gl) {
  for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_COLOR_ARRAY})
    gl.DisableClientState(array);
}

void drawPieces(Gl gl, const Plan& plan, const std::byte* numbers) {
  const auto pieces = static_cast<GLsizei>(plan.pieces);
  const GLsizei each = plan.count / 3 / pieces * 3;
  const size_t size = plan.numberType == GL_UNSIGNED_INT ? 4 : plan.numberType == GL_UNSIGNED_SHORT ? 2 : 1;
  std::vector<GLint> firsts;
  std::vector<GLsizei> counts;
  std::vector<const void*> places;
  for (GLsizei i = 0; i < pieces; ++i) {
    firsts.push_back(plan.first + i * each);
    counts.push_back(i + 1 == pieces ? plan.count - i * each : each);
    places.push_back(reinterpret_cast<const void*>(reinterpret_cast<uintptr_t>(numbers) +
                                                   static_cast<size_t>(i * each) * size));
  }
  if (plan.multi && plan.numberType)
    gl.MultiDrawElements(GL_TRIANGLES, counts.data(), plan.numberType, places.data(), pieces);
  else if (plan.multi)
    gl.MultiDrawArrays(GL_TRIANGLES, firsts.data(), counts.data(), pieces);
  else if (plan.numberType && plan.range)
    gl.DrawRangeElements(GL_TRIANGLES, 0, plan.elements - 1, plan.count, plan.numberType, numbers);
  else if (plan.numberType)
    gl.DrawElements(GL_TRIANGLES, plan.count, plan.numberType, numbers);
  else
    gl.DrawArrays(GL_TRIANGLES, plan.first, plan.count);
}

std::string describe(const Plan& plan, const char* how) {
  std::ostringstream out;
  out << how << ": " << plan.count << (plan.numberType ? " numbers of " : " vertices of ") << plan.elements
      << (plan.inBuffers ? ", in a buffer" : "") << (plan.numbersInBuffer ? ", numbers in a buffer" : "")
      << (plan.interleaved ? ", glInterleavedArrays" : "") << (plan.multi ? ", glMultiDraw" : "")
      << (plan.range ? ", range" : "") << ", first " << plan.first << ", type of numbers 0x" << std::hex
      << plan.numberType << std::dec;
  constexpr const char* kNames[] = {"vertex", "normal", "color", "texcoord"};
  for (size_t i = 0; i < 4; ++i)
    if (const ArrayLayout& a = *layouts(plan, i); a.enabled)
      out << "; " << kNames[i] << " " << a.size << " of 0x" << std::hex << a.type << std::dec << ", stride "
          << a.stride << ", offset " << a.offset;
  return out.str();
}

/// Sets the arrays, calls body(numbers), and takes the arrays away.
template <class Body>
void withArrays(Gl gl, const Plan& plan, Body&& body) {
  if (plan.inBuffers) bindBufferWith(gl, GL_ARRAY_BUFFER, plan.memory);
  setArrays(gl, plan, plan.inBuffers ? nullptr : plan.memory->data());
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  if (plan.numbersInBuffer) bindBufferWith(gl, GL_ELEMENT_ARRAY_BUFFER, plan.numbers);
  body(plan.numbersInBuffer || !plan.numbers ? nullptr : plan.numbers->data());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
  dropArrays(gl);
}

/// Sets the attributes of `attributes`, which have become undefined.
void writeDefined(Writer& w, const Attributes& attributes, bool asks) {
  const auto color = w.dice.color();
  const std::array<GLfloat, 3> normal = {w.dice.real(-1, 1), 0.5f, 1};
  w.call(asks ? "attributes set again, colour asked" : "attributes set again", [=](Gl gl, Answers&) {
    if (attributes.colors) gl.Color4fv(color.data());
    if (attributes.normals) gl.Normal3fv(normal.data());
    if (attributes.texcoords) gl.TexCoord2f(0.27f, 0.77f);
    GLfloat asked[4];
    if (asks) gl.GetFloatv(GL_CURRENT_COLOR, asked);
  });
}

}  // namespace

void writeArrays(Writer& w, const Shape& shape, const Attributes& wished, bool list) {
  Attributes attributes = wished;
  const Plan plan = makePlan(w, shape, attributes);
  w.call(describe(plan, "arrays"), [=](Gl gl, Answers&) {
    withArrays(gl, plan, [&](const std::byte* numbers) { drawPieces(gl, plan, numbers); });
  });
  writeDefined(w, attributes, !list && w.dice.chance(50));
  w.join(2);
}

void writeArrayElements(Writer& w, const Shape& shape, const Attributes& wished) {
  Attributes attributes = wished;
  Plan plan = makePlan(w, shape, attributes);
  const std::vector<uint32_t> triangles = trianglesOf(shape);
  const bool numbered = plan.numberType != 0;
  w.call(describe(plan, "glArrayElement"), [=](Gl gl, Answers&) {
    withArrays(gl, plan, [&](const std::byte*) {
      gl.Begin(GL_TRIANGLES);
      for (GLint i = 0; i < plan.count; ++i)
        gl.ArrayElement(numbered ? static_cast<GLint>(triangles[static_cast<size_t>(i)]) : plan.first + i);
      gl.End();
    });
  });
}

}  // namespace gluray::fuzz
