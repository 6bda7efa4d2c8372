// The shaders of Avogadro 2's atoms, bonds and meshes, and what is drawn with them. For
// avogadro_test.cpp and avogadro_refused_test.cpp.
#pragma once
#include "tests/reference/programs/program_mutants.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace gluray::test {

enum class AvogadroKind { spheres, cylinders, meshes, meshesFromWithin };

std::string avogadroVertexText(AvogadroKind kind);
std::string avogadroFragmentText(AvogadroKind kind);
inline ShaderTexts avogadroTexts(AvogadroKind kind) {
  return {{GL_VERTEX_SHADER, avogadroVertexText(kind)}, {GL_FRAGMENT_SHADER, avogadroFragmentText(kind)}};
}

struct Atom {
  glm::vec3 center;
  float radius;
  glm::u8vec3 color;
};
/// Sixty atoms about the origin.
std::vector<Atom> manyAtoms();

/// A vertex as Avogadro lays it out, with a corner of a square of two radii.
struct AtomCorner {
  glm::vec3 center;
  glm::u8vec4 color;
  glm::vec2 corner;
  glm::vec2 unused;
};
struct AtomCorners {
  std::vector<AtomCorner> vertices;
  std::vector<GLuint> indices;
  explicit AtomCorners(const std::vector<Atom>& atoms);
};

/// Uses the program, sets its uniforms, draws.
void drawAtoms(Gl gl, GLuint program, const AtomCorners& atoms, const View& view, float opacity = 1);
void drawAvogadroMesh(Gl gl, GLuint program, const ProgramMesh& mesh, const View& view);

}  // namespace gluray::test
