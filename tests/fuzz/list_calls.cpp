#include "tests/fuzz/calls.h"

namespace gluray::fuzz {
namespace {

constexpr uint32_t kLists = 10;
// Lists from kAttributes on hold only attributes: they may be called between glBegin and glEnd (avoided.md).
constexpr GLuint kAttributes = 11, kAttributeLists = 2;

/// A list that calls two lists may call itself twice, 2^64 times in all: allows one call in each. Mesa 22.3
/// crashes at a compiled call of a list that does not exist.
bool mayCall(Player& p, GLuint name) {
  if (!p.compiling) return true;
  if (p.listCalled || !p.gl.IsList(name)) return false;
  return p.listCalled = true;
}

void callLists(Player& p) {
  const GLuint first = p.name(kLists), second = p.name(kLists);
  const GLsizei count = p.count(2);
  if (p.compiling || p.insideBegin) return;
  const GLenum type = p.pick({GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_INT, GL_FLOAT, GL_2_BYTES});
  // As many bytes as three names of any type may take.
  union {
    GLubyte bytes[32];
    GLshort shorts[16];
    GLuint words[8];
    GLfloat floats[8];
  } names = {};
  const auto a = static_cast<GLubyte>(first), b = static_cast<GLubyte>(second);
  switch (type) {
    case GL_SHORT: names.shorts[0] = a, names.shorts[1] = b; break;
    case GL_UNSIGNED_INT: names.words[0] = first, names.words[1] = second; break;
    case GL_FLOAT: names.floats[0] = a, names.floats[1] = b; break;
    case GL_2_BYTES: names.bytes[1] = a, names.bytes[3] = b; break;
    default: names.bytes[0] = a, names.bytes[1] = b;
  }
  p.gl.CallLists(count, type, names.bytes);
}

const Op kListOps[] = {
    {"CallList", 20,
     [](Player& p) {
       const GLuint name = p.name(kLists);
       if (!p.insideBegin && mayCall(p, name)) p.gl.CallList(name);
     }},
    {"CallLists", 5, callLists},
    {"ListBase", 2, [](Player& p) { p.gl.ListBase(p.below(4)); }},
    {"ListBase 0", 2, [](Player& p) { p.gl.ListBase(0); }},
    {"DeleteLists", 4,
     [](Player& p) {
       const GLuint first = p.name(kLists);
       if (p.compiling) return;
       p.gl.DeleteLists(first, p.count(3));
     }},
    {"GenLists", 2,
     [](Player& p) {
       const GLsizei count = p.count(2);
       if (!p.executing) p.answer("GenLists", {static_cast<double>(p.gl.GenLists(count))});
     }},
    {"IsList", 2,
     [](Player& p) {
       const GLuint name = p.name(kLists);
       if (!p.executing) p.answer("IsList", {static_cast<double>(p.gl.IsList(name))});
     }},
};

const Op kNewListOps[] = {
    {"NewList", 1,
     [](Player& p) {
       const GLuint name = p.name(kLists);
       const GLenum mode = p.pick({GL_COMPILE, GL_COMPILE, GL_COMPILE_AND_EXECUTE});
       if (p.compiling || p.insideBegin) return;
       p.gl.Color4f(0.5f, 0.25f, 0.75f, 1);  // avoided.md
       p.compiling = true, p.executing = mode == GL_COMPILE_AND_EXECUTE;
       p.gl.NewList(name, mode);
     }},
};
const Op kNewAttributeListOps[] = {
    {"NewList of attributes", 1,
     [](Player& p) {
       const GLuint name = kAttributes + p.below(kAttributeLists);
       if (p.compiling || p.insideBegin) return;
       p.compiling = true;
       p.gl.NewList(name, GL_COMPILE);
     }},
};
const Op kCallAttributesOps[] = {
    {"CallList of attributes", 1,
     [](Player& p) {
       const GLuint name = kAttributes + p.below(kAttributeLists);
       if (!p.compiling) p.gl.CallList(name);
     }},
};
const Op kEndListOps[] = {
    {"EndList", 1,
     [](Player& p) {
       p.gl.EndList();
       if (p.insideBegin) return;
       // Attributes that are new in the middle of a primitive cause spurious errors in Mesa.
       while (p.executing && p.gl.GetError() != GL_NO_ERROR) continue;
       p.compiling = p.executing = p.listCalled = p.grown = false;
     }},
};

}  // namespace

Ops listCalls() { return kListOps; }
Ops newListCalls() { return kNewListOps; }
Ops newAttributeListCalls() { return kNewAttributeListOps; }
Ops callAttributesCalls() { return kCallAttributesOps; }
Ops endListCalls() { return kEndListOps; }

}  // namespace gluray::fuzz
