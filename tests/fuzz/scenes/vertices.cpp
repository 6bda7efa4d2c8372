#include "tests/fuzz/scenes/vertices.h"

#include <GL/gl.h>

namespace gluray::fuzz {
namespace {

void writeCorner(Writer& w, const Corner& corner, const Attributes& attributes) {
  // One call for all attributes of a vertex: there are thousands.
  w.calls.push_back({Role::vertex,
                     [=](Gl gl, Answers&) {
                       if (attributes.normals) gl.Normal3fv(corner.normal.data());
                       if (attributes.texcoords) gl.TexCoord2fv(corner.texcoord.data());
                       if (attributes.colors) gl.Color4fv(corner.color.data());
                       gl.Vertex3fv(corner.position.data());
                     },
                     [=] {
                       std::string text;
                       if (attributes.normals) text += "glNormal3fv(" + printed(corner.normal) + ") ";
                       if (attributes.texcoords) text += "glTexCoord2fv(" + printed(corner.texcoord) + ") ";
                       if (attributes.colors) text += "glColor4fv(" + printed(corner.color) + ") ";
                       return text + "glVertex3fv(" + printed(corner.position) + ")";
                     }});
}

}  // namespace

void writeMaterial(Writer& w, Writer::At at) {
  const GLenum face = w.face(at);
  if (w.dice.chance(15)) {
    WRITE(w, Materialf, face, GLenum{GL_SHININESS}, w.dice.real(1, 60));  // 0: avoided.md
    return;
  }
  const GLenum name = w.dice.pick({GL_DIFFUSE, GL_AMBIENT, GL_AMBIENT_AND_DIFFUSE, GL_SPECULAR, GL_EMISSION});
  WRITE(w, Materialfv, face, name, w.dice.color());
}

void writePrimitives(Writer& w, const Shape& shape, const Attributes& attributes, bool asTriangles,
                     Materials materials) {
  const GLenum face = w.face(Writer::At::inside);
  const GLenum name = w.dice.pick({GL_DIFFUSE, GL_AMBIENT, GL_AMBIENT_AND_DIFFUSE, GL_SPECULAR, GL_EMISSION});
  const auto corner = [&](uint32_t number, bool first = false) {
    const bool changes = materials != Materials::none && w.dice.chance(5);
    const size_t before = w.calls.size();
    if (materials == Materials::inLists && (first || changes))
      WRITE(w, Materialfv, face, name, w.dice.color());
    else if (changes)
      writeMaterial(w, Writer::At::inside);
    writeCorner(w, shape.corners[number], attributes);
    // Together: the shrinker leaves no material after the last vertex (avoided.md).
    w.join(w.calls.size() - before);
  };
  const auto at = [&](uint32_t column, uint32_t row) { return row * shape.columns + column; };
  const auto triangles = [&](GLenum mode) {
    const std::vector<uint32_t> numbers = trianglesOf(shape);
    for (size_t i = 0; i < numbers.size(); ++i) {
      if (mode == GL_POLYGON ? i % 3 == 0 : i == 0) WRITE_AS(w, begin, Begin, mode);
      corner(numbers[i], mode == GL_POLYGON ? i % 3 == 0 : i == 0);
      if (i % 3 == 2) w.join(3);  // the shrinker makes no triangles of other corners
      if (mode == GL_POLYGON ? i % 3 == 2 : i + 1 == numbers.size()) WRITE_AS(w, end, End);
    }
  };
  switch (asTriangles ? 3 : w.dice.below(5)) {
    case 0:
      for (uint32_t j = 0; j + 1 < shape.rows; ++j) {
        WRITE_AS(w, begin, Begin, GLenum{GL_TRIANGLE_STRIP});
        for (uint32_t i = 0; i < shape.columns; ++i) corner(at(i, j), i == 0), corner(at(i, j + 1));
        WRITE_AS(w, end, End);
      }
      return;
    case 1:
      for (uint32_t j = 0; j + 1 < shape.rows; ++j)
        for (uint32_t i = 0; i + 1 < shape.columns; ++i) {
          WRITE_AS(w, begin, Begin, GLenum{GL_TRIANGLE_FAN});
          corner(at(i, j), true), corner(at(i + 1, j)), corner(at(i + 1, j + 1)), corner(at(i, j + 1));
          WRITE_AS(w, end, End);
        }
      return;
    case 2: return triangles(shape.corners.size() < 40 ? GL_POLYGON : GL_TRIANGLES);
    default: return triangles(GL_TRIANGLES);
  }
}

void writeMarks(Writer& w) {
  WRITE_AS(w, begin, Begin, w.dice.pick({GL_LINES, GL_POINTS, GL_LINE_STRIP, GL_LINE_LOOP}));
  for (int i = 0; i < 4; ++i) {
    const size_t before = w.calls.size();
    if (w.dice.chance(50)) WRITE(w, Color4fv, w.dice.color());
    if (w.dice.chance(30)) writeMaterial(w);
    if (w.dice.chance(30)) WRITE(w, Normal3f, w.dice.real(-1, 1), 0.5f, 1.0f);
    const float x = w.dice.real(-2, 2), y = w.dice.real(-2, 2), z = w.dice.real(-2, 2);
    WRITE_AS(w, vertex, Vertex3f, x, y, z);
    w.join(w.calls.size() - before);
  }
  WRITE_AS(w, end, End);
}

}  // namespace gluray::fuzz
