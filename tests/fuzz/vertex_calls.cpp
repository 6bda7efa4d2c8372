#include "tests/fuzz/calls.h"

namespace gluray::fuzz {
namespace {

void material(Player& p) {
  const GLenum face = p.pick({GL_FRONT, GL_BACK, GL_FRONT_AND_BACK});
  const GLenum name = p.pick({GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_AMBIENT_AND_DIFFUSE});
  p.gl.Materialfv(face, name, p.reals<4>().data());
}

const Op kVertexOps[] = {
    {"Materialfv", 10, material},
    {"Materialf", 3,
     [](Player& p) {
       const GLenum face = p.pick({GL_FRONT, GL_BACK, GL_FRONT_AND_BACK});
       const GLenum name = p.pick({GL_SHININESS});
       p.gl.Materialf(face, name, 64 * p.real());
     }},
    {"Materialiv", 2,
     [](Player& p) {
       const GLenum face = p.pick({GL_FRONT, GL_BACK, GL_FRONT_AND_BACK});
       const GLenum name = p.pick({GL_DIFFUSE, GL_AMBIENT, GL_SHININESS});
       const GLint v[4] = {p.integer(), p.integer(), p.integer(), p.integer()};
       p.gl.Materialiv(face, name, v);
     }},
    {"ArrayElement", 6,
     [](Player& p) {
       if (!p.smallBuffers) p.gl.ArrayElement(static_cast<GLint>(p.below(200)));
     }},
    {"EvalCoord1f", 1, [](Player& p) { p.gl.EvalCoord1f(p.real()); }},
    {"EvalCoord2f", 1,
     [](Player& p) {
       const float u = p.real(), v = p.real();
       p.gl.EvalCoord2f(u, v);
     }},
    {"EvalPoint1", 1, [](Player& p) { p.gl.EvalPoint1(p.integer()); }},
    {"EvalPoint2", 1,
     [](Player& p) {
       const GLint i = p.integer(), j = p.integer();
       p.gl.EvalPoint2(i, j);
     }},
};

const Op kBeginOps[] = {
    {"Begin", 1,
     [](Player& p) {
       p.insideBegin = p.vertexWanted = true;
       p.gl.Begin(p.pick({GL_TRIANGLES, GL_TRIANGLES, GL_TRIANGLES, GL_QUADS, GL_QUADS, GL_TRIANGLE_STRIP,
                          GL_TRIANGLE_FAN, GL_QUAD_STRIP, GL_POLYGON, GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP,
                          GL_POINTS}));
     }},
};
const Op kEndOps[] = {
    {"End", 1,
     [](Player& p) {
       if (p.compiling && p.vertexWanted) p.gl.Vertex2f(0, 0);  // avoided.md
       p.insideBegin = p.vertexWanted = false, p.gl.End();
     }},
};

}  // namespace

Ops vertexCalls() { return kVertexOps; }
Ops beginCalls() { return kBeginOps; }
Ops endCalls() { return kEndOps; }

}  // namespace gluray::fuzz
