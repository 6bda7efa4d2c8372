#include "tests/fuzz/calls.h"

namespace gluray::fuzz {
namespace {

/// A place for a vertex array: in a buffer, which is bound, or in memory.
const void* place(Player& p) {
  const bool inBuffer = p.below(2);
  const GLuint buffer = inBuffer ? 1 + p.below(kVertexBuffers) : 0;
  p.gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  return inBuffer ? reinterpret_cast<const void*>(static_cast<uintptr_t>(4 * p.below(32))) : p.read();
}

GLsizei stride(Player& p) {
  static constexpr GLsizei kStrides[] = {0, 0, 0, 12, 16, 24, 32, 48, 3};
  return kStrides[p.below(std::size(kStrides))];
}

/// Between glBegin and glEnd the binding would fail and the pointer point at nothing.
template <void (*Set)(Player&, const void*)>
void pointer(Player& p) {
  if (p.insideBegin) return;
  Set(p, place(p));
}

GLenum number(Player& p) { return p.pick({GL_FLOAT, GL_FLOAT, GL_FLOAT, GL_SHORT, GL_INT, GL_DOUBLE}); }
GLenum arrayName(Player& p) {
  return p.pick({GL_VERTEX_ARRAY, GL_VERTEX_ARRAY, GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY,
                 GL_TEXTURE_COORD_ARRAY, GL_SECONDARY_COLOR_ARRAY, GL_FOG_COORD_ARRAY, GL_EDGE_FLAG_ARRAY});
}

const Op kArrayOps[] = {
    {"VertexPointer", 10, pointer<[](Player& p, const void* at) {
       const GLint size = 2 + static_cast<GLint>(p.below(p.chance(5) ? 5 : 3));
       const GLenum type = number(p);
       p.gl.VertexPointer(size, type, stride(p), at);
     }>},
    {"NormalPointer", 5, pointer<[](Player& p, const void* at) {
       const GLenum type = p.pick({GL_FLOAT, GL_BYTE, GL_SHORT, GL_DOUBLE});
       p.gl.NormalPointer(type, stride(p), at);
     }>},
    {"ColorPointer", 5, pointer<[](Player& p, const void* at) {
       const GLint size = 3 + static_cast<GLint>(p.below(2));
       const GLenum type = p.pick({GL_UNSIGNED_BYTE, GL_FLOAT, GL_SHORT, GL_UNSIGNED_INT});
       p.gl.ColorPointer(size, type, stride(p), at);
     }>},
    {"ColorPointer BGRA", 1,
     pointer<[](Player& p, const void* at) { p.gl.ColorPointer(GL_BGRA, GL_UNSIGNED_BYTE, stride(p), at); }>},
    {"TexCoordPointer", 4, pointer<[](Player& p, const void* at) {
       const GLint size = 1 + static_cast<GLint>(p.below(4));
       const GLenum type = number(p);
       p.gl.TexCoordPointer(size, type, stride(p), at);
     }>},
    {"SecondaryColorPointer", 1,
     pointer<[](Player& p, const void* at) { p.gl.SecondaryColorPointer(3, GL_FLOAT, stride(p), at); }>},
    {"FogCoordPointer", 1,
     pointer<[](Player& p, const void* at) { p.gl.FogCoordPointer(GL_FLOAT, stride(p), at); }>},
    {"EdgeFlagPointer", 1, pointer<[](Player& p, const void* at) { p.gl.EdgeFlagPointer(stride(p), at); }>},
    {"InterleavedArrays", 3, pointer<[](Player& p, const void* at) {
       p.gl.InterleavedArrays(
           p.pick({GL_V3F, GL_N3F_V3F, GL_C4UB_V3F, GL_C4F_N3F_V3F, GL_T2F_V3F, GL_T2F_C4UB_V3F, GL_V2F}), 0,
           at);
     }>},
    {"VertexAttribPointer", 2, pointer<[](Player& p, const void* at) {
       const GLuint index = p.below(4);
       const GLint size = 1 + static_cast<GLint>(p.below(4));
       const GLenum type = number(p);
       const GLboolean normalized = p.flag();
       p.gl.VertexAttribPointer(index, size, type, normalized, stride(p), at);
       p.gl.EnableVertexAttribArray(index);
     }>},
    {"DisableVertexAttribArray", 4, [](Player& p) { p.gl.DisableVertexAttribArray(p.below(4)); }},
    {"EnableClientState", 14, [](Player& p) { p.gl.EnableClientState(arrayName(p)); }},
    {"DisableClientState", 6, [](Player& p) { p.gl.DisableClientState(arrayName(p)); }},
    {"ClientActiveTexture", 2,
     [](Player& p) {
       p.gl.ClientActiveTexture(p.pick({GL_TEXTURE0, GL_TEXTURE0, GL_TEXTURE1}));
     }},
    {"PrimitiveRestartIndex", 1, [](Player& p) { p.gl.PrimitiveRestartIndex(p.below(200)); }},
};

GLenum mode(Player& p) {
  return p.pick({GL_TRIANGLES, GL_TRIANGLES, GL_TRIANGLES, GL_QUADS, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN,
                 GL_QUAD_STRIP, GL_POLYGON, GL_LINES, GL_POINTS, GL_LINE_LOOP});
}

/// Current attributes are undefined after a draw from arrays; Mesa's lists and GLuRay's leave others.
void setCurrent(Player& p) {
  constexpr GLfloat v[4] = {0.25f, 0.5f, 0.75f, 1};
  p.gl.Normal3fv(v), p.gl.Color4fv(v), p.gl.SecondaryColor3fv(v), p.gl.FogCoordf(0.5f), p.gl.Indexf(1);
  p.gl.EdgeFlag(GL_TRUE);
  for (const GLenum unit : {GL_TEXTURE0, GL_TEXTURE1}) {
    if (p.attributeSize == 1) p.gl.MultiTexCoord1fv(unit, v);
    if (p.attributeSize == 2) p.gl.MultiTexCoord2fv(unit, v);
    if (p.attributeSize == 3) p.gl.MultiTexCoord3fv(unit, v);
    if (p.attributeSize == 4) p.gl.MultiTexCoord4fv(unit, v);
  }
  for (GLuint i = 1; i < 4; ++i) {
    if (p.attributeSize == 1) p.gl.VertexAttrib1fv(i, v);
    if (p.attributeSize == 2) p.gl.VertexAttrib2fv(i, v);
    if (p.attributeSize == 3) p.gl.VertexAttrib3fv(i, v);
    if (p.attributeSize == 4) p.gl.VertexAttrib4fv(i, v);
  }
}

/// Leaves out draws that crash Mesa.
template <void (*Draw)(Player&, GLenum)>
void draw(Player& p) {
  if (p.compiling && p.smallBuffers) return;
  Draw(p, mode(p));
  if (p.compiling && !p.insideBegin) setCurrent(p);
}

struct Indices {
  GLenum type;
  const void* at;
};
/// Indices in memory or, as 16 bit numbers, in a buffer.
Indices indices(Player& p) {
  const uint32_t kind = p.below(4);
  p.gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, kind == 3 ? kIndexBuffer : 0);
  // Writes the indices again: other data there would reach beyond the arrays.
  if (kind == 3)
    p.gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof source().indices16, source().indices16.data(),
                    GL_STATIC_DRAW);
  switch (kind) {
    case 0: return {GL_UNSIGNED_BYTE, source().indices8.data()};
    case 1: return {GL_UNSIGNED_SHORT, source().indices16.data()};
    case 2: return {GL_UNSIGNED_INT, source().indices32.data()};
    default: return {GL_UNSIGNED_SHORT, nullptr};
  }
}

const Op kDrawOps[] = {
    {"DrawArrays", 20, draw<[](Player& p, GLenum m) {
       const GLint first = static_cast<GLint>(p.below(20));
       p.gl.DrawArrays(m, first, p.count(60));
     }>},
    {"DrawElements", 20, draw<[](Player& p, GLenum m) {
       if (p.insideBegin) return;
       const Indices i = indices(p);
       p.gl.DrawElements(m, p.count(60), i.type, i.at);
     }>},
    {"DrawRangeElements", 4, draw<[](Player& p, GLenum m) {
       if (p.insideBegin) return;
       const Indices i = indices(p);
       const GLsizei count = p.count(60);
       p.gl.DrawRangeElements(m, p.chance(3) ? 300 : 0, 255, count, i.type, i.at);
     }>},
    {"DrawElementsBaseVertex", 3, draw<[](Player& p, GLenum m) {
       if (p.insideBegin) return;
       const Indices i = indices(p);
       const GLsizei count = p.count(60);
       p.gl.DrawElementsBaseVertex(m, count, i.type, i.at, static_cast<GLint>(p.below(20)));
     }>},
    {"MultiDrawArrays", 2, draw<[](Player& p, GLenum m) {
       const GLint first[2] = {static_cast<GLint>(p.below(20)), static_cast<GLint>(p.below(20))};
       const GLsizei counts[2] = {p.count(20), p.count(20)};
       p.gl.MultiDrawArrays(m, first, counts, p.chance(5) ? -1 : 2);
     }>},
    {"MultiDrawElements", 2, draw<[](Player& p, GLenum m) {
       if (p.insideBegin) return;
       const Indices i = indices(p);
       const void* const at[2] = {i.at, i.at};
       const GLsizei counts[2] = {p.count(20), p.count(20)};
       p.gl.MultiDrawElements(m, counts, i.type, at, 2);
     }>},
    {"DrawArraysInstanced", 2, draw<[](Player& p, GLenum m) {
       const GLsizei count = p.count(30);
       p.gl.DrawArraysInstanced(m, 0, count, p.count(3));
     }>},
    {"DrawElementsInstanced", 1, draw<[](Player& p, GLenum m) {
       if (p.insideBegin) return;
       const Indices i = indices(p);
       const GLsizei count = p.count(30);
       p.gl.DrawElementsInstanced(m, count, i.type, i.at, p.count(3));
     }>},
    {"Rectf", 4,
     [](Player& p) {
       const auto v = p.reals<4>();
       p.gl.Rectf(v[0], v[1], v[2], v[3]);
     }},
    {"Rectiv", 1,
     [](Player& p) {
       const GLint a[2] = {p.integer(), p.integer()}, b[2] = {p.integer(), p.integer()};
       p.gl.Rectiv(a, b);
     }},
    {"EvalMesh1", 1,
     [](Player& p) {
       const GLenum m = p.pick({GL_LINE, GL_POINT});
       p.gl.EvalMesh1(m, 0, static_cast<GLint>(p.below(5)));
     }},
    {"EvalMesh2", 2,
     [](Player& p) {
       const GLenum m = p.pick({GL_FILL, GL_FILL, GL_LINE, GL_POINT});
       const auto i = static_cast<GLint>(p.below(5)), j = static_cast<GLint>(p.below(5));
       p.gl.EvalMesh2(m, 0, i, 0, j);
     }},
};

}  // namespace

Ops arrayCalls() { return kArrayOps; }
Ops drawCalls() { return kDrawOps; }

}  // namespace gluray::fuzz
