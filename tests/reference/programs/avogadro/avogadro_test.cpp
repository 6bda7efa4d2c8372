// Avogadro 2's programs: what they compute is what is traced.
#include "tests/reference/framebuffer.h"
#include "tests/reference/programs/avogadro/avogadro_text.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace gluray::test {
namespace {

using Kind = AvogadroKind;

const ContextWish kAvogadroWish{kProgramWidth, kProgramHeight};

void beginAtoms(Gl gl) { beginFrame(gl), gl.DepthFunc(GL_LESS), gl.Disable(GL_BLEND); }

void expectAtoms(const std::string& name, const std::vector<Atom>& list, const View& view) {
  const AtomCorners atoms(list);
  expectBoth(
      "avogadro_" + name,
      [&](Gl gl) {
        beginAtoms(gl);
        drawAtoms(gl, linked(gl, avogadroTexts(Kind::spheres)), atoms, view);
      },
      1, kAvogadroWish);
}

TEST(Avogadro, AtomsInPerspectiveAndInParallel) {
  expectAtoms("atoms", manyAtoms(), perspectiveView(35));
  expectAtoms("atoms_parallel", manyAtoms(), parallelView(35));
}

/// Near the border of a wide view a half sphere along -z and a sphere look most different.
TEST(Avogadro, LargeAtomsAtTheBorderOfAWideView) {
  View view;
  view.clipFromEye = glm::perspective(glm::radians(80.0), 4.0 / 3, 0.2, 10.0);
  expectAtoms("wide",
              {{{1.7f, 0.9f, -2.6f}, 0.9f, {250, 120, 50}},
               {{-1.5f, -0.9f, -2.2f}, 0.8f, {70, 150, 250}},
               {{-1.1f, 1.0f, -2.0f}, 0.5f, {0, 0, 0}},
               {{0.2f, -1.3f, -2.3f}, 0.7f, {255, 255, 255}}},
              view);
}

/// Atoms that reach through the near plane do not exist; those whose centre is beyond the far one neither.
TEST(Avogadro, AtomsAtTheNearAndTheFarPlane) {
  for (const double distance : {1.9, 10.0}) {
    View view = perspectiveView(35);
    view.eyeFromObject =
        glm::translate(glm::dmat4(1), {0, 0, -distance}) * glm::dmat4(glm::dmat3(view.eyeFromObject));
    expectAtoms("planes_" + std::to_string(static_cast<int>(distance)), manyAtoms(), view);
  }
}

TEST(Avogadro, AtomsThatTouchBondsAreHiddenByDepth) {
  const AtomCorners atoms(manyAtoms());
  ProgramMesh bond = ball(24);
  for (glm::vec3& p : bond.positions) p *= glm::vec3(1.3f, 0.4f, 0.9f);
  for (const View& view : {perspectiveView(20), parallelView(20)})
    expectBoth(
        "avogadro_atoms_and_bonds",
        [&](Gl gl) {
          beginAtoms(gl);
          drawAtoms(gl, linked(gl, avogadroTexts(Kind::spheres)), atoms, view);
          drawAvogadroMesh(gl, linked(gl, avogadroTexts(Kind::cylinders)), bond, view);
        },
        2, kAvogadroWish);
}

TEST(Avogadro, FourSamplesAPixel) {
  const AtomCorners atoms(manyAtoms());
  expectBoth(
      "avogadro_4x",
      [&](Gl gl) {
        const glm::ivec2 size(kProgramWidth, kProgramHeight);
        bindNewFramebuffer(gl, size, GL_RGBA8, GL_DEPTH24_STENCIL8, 4);
        beginAtoms(gl);
        drawAtoms(gl, linked(gl, avogadroTexts(Kind::spheres)), atoms, perspectiveView(35));
        drawAvogadroMesh(gl, linked(gl, avogadroTexts(Kind::cylinders)), ball(16), perspectiveView(35));
        gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
        gl.BlitFramebuffer(0, 0, size.x, size.y, 0, 0, size.x, size.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
      },
      2, kAvogadroWish);
}

TEST(Avogadro, TranslucentAtomsBlendInTheOrderOfDrawing) {
  const AtomCorners atoms(manyAtoms());
  expectBoth(
      "avogadro_translucent",
      [&](Gl gl) {
        beginAtoms(gl);
        gl.Enable(GL_BLEND);
        gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE);
        drawAtoms(gl, linked(gl, avogadroTexts(Kind::spheres)), atoms, perspectiveView(35), 0.6f);
      },
      1, kAvogadroWish);
}

TEST(Avogadro, TheViewerTurnsAndNothingIsBuilt) {
  const AtomCorners atoms(manyAtoms());
  const Outcome outcome = expectSame(
      "avogadro_turned",
      [&](Gl gl) {
        beginAtoms(gl);
        const GLuint program = linked(gl, avogadroTexts(Kind::spheres));
        drawAtoms(gl, program, atoms, perspectiveView(35));
        for (const double degrees : {50.0, 70.0}) {
          gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
          setMat4(gl, program, "modelView", glm::mat4(perspectiveView(degrees).eyeFromObject));
          gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(atoms.indices.size()), GL_UNSIGNED_INT, nullptr);
        }
      },
      3, kAvogadroWish);
  EXPECT_EQ(outcome.statistics.meshesBuilt, 1u);
}

struct AvogadroMeshCase {
  const char* name;
  Kind kind;
};
void PrintTo(const AvogadroMeshCase& c, std::ostream* out) { *out << c.name; }
const AvogadroMeshCase kAvogadroMeshes[] = {
    {"cylinders", Kind::cylinders}, {"meshes", Kind::meshes}, {"from_within", Kind::meshesFromWithin}};

class AvogadroMeshes : public testing::TestWithParam<AvogadroMeshCase> {};

TEST_P(AvogadroMeshes, AreTraced) {
  const auto& [name, kind] = GetParam();
  ProgramMesh bowl = ball(24);  // both sides of its triangles are visible
  bowl.indices.resize(bowl.indices.size() / 6 * 3);
  for (const View& view : {perspectiveView(35), parallelView(110)})
    expectBoth(
        std::string("avogadro_") + name,
        [&, kind = kind](Gl gl) {
          beginAtoms(gl);
          drawAvogadroMesh(gl, linked(gl, avogadroTexts(kind)), bowl, view);
        },
        1, kAvogadroWish);
}

TEST_P(AvogadroMeshes, ThatAreChangedAreNotTakenForTheOriginal) {
  const auto& [name, kind] = GetParam();
  expectMutantsSeen(
      std::string("avogadro_") + name, avogadroTexts(kind),
      [](Gl gl, GLuint program) {
        beginAtoms(gl);
        drawAvogadroMesh(gl, program, ball(12), perspectiveView(25));
      },
      kAvogadroWish);
}

INSTANTIATE_TEST_SUITE_P(All, AvogadroMeshes, testing::ValuesIn(kAvogadroMeshes),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(Avogadro, ChangedAtomsAreNotTakenForTheOriginal) {
  const AtomCorners atoms(manyAtoms());
  for (const View& view : {perspectiveView(25), parallelView(25)})
    expectMutantsSeen(
        "avogadro_atoms", avogadroTexts(Kind::spheres),
        [&](Gl gl, GLuint program) {
          beginAtoms(gl);
          drawAtoms(gl, program, atoms, view);
        },
        kAvogadroWish);
}

}  // namespace
}  // namespace gluray::test
