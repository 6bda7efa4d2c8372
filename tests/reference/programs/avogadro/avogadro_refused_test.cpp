// Avogadro 2's atoms: what is left to the real OpenGL.
#include "tests/reference/programs/avogadro/avogadro_text.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace gluray::test {
namespace {

void expectAtomsRefused(
    const std::string& name, const AtomCorners& atoms, const View& view = perspectiveView(35),
    const std::function<void(Gl)>& change = [](Gl) {}) {
  expectSame("avogadro_refused_" + name,
             [&](Gl gl) {
               beginFrame(gl), gl.DepthFunc(GL_LESS), gl.Disable(GL_BLEND);
               change(gl);
               drawAtoms(gl, linked(gl, avogadroTexts(AvogadroKind::spheres)), atoms, view);
             },
             0, {kProgramWidth, kProgramHeight});
}

TEST(AvogadroRefused, SquaresThatAreNotAboutTheirCentres) {
  AtomCorners atoms(manyAtoms());
  atoms.vertices[5].corner.y *= 2;
  expectAtomsRefused("oblong", atoms);
  atoms = AtomCorners(manyAtoms());
  for (size_t k = 0; k < 4; ++k) atoms.vertices[k].corner.y *= 0.5f;
  expectAtomsRefused("flat", atoms);
  atoms = AtomCorners(manyAtoms());
  atoms.vertices[9].corner *= 1.5f;
  expectAtomsRefused("radii", atoms);
  atoms = AtomCorners(manyAtoms());
  atoms.vertices[2].corner.x *= -1;
  expectAtomsRefused("corner", atoms);
  atoms = AtomCorners(manyAtoms());
  for (size_t k = 0; k < 4; ++k) atoms.vertices[k].corner = {};
  expectAtomsRefused("no_radius", atoms);
}

TEST(AvogadroRefused, OtherProjectionsAndStates) {
  const AtomCorners atoms(manyAtoms());
  View skewed = perspectiveView(35);
  skewed.clipFromEye[0].z = 0.1;  // depths that depend on x
  expectAtomsRefused("skewed", atoms, skewed);
  expectAtomsRefused("culled", atoms, perspectiveView(35),
                     [](Gl gl) { gl.Enable(GL_CULL_FACE), gl.FrontFace(GL_CW); });
  expectAtomsRefused("depth_range", atoms, perspectiveView(35), [](Gl gl) { gl.DepthRange(0, 0.5); });
}

}  // namespace
}  // namespace gluray::test
