// What users are told of a shader program.
#include "gl/programs/match.h"
#include "tests/reference/programs/program_stage.h"

#include <gtest/gtest.h>

#include <string>

namespace gluray::test {
namespace {

const GLubyte* APIENTRY nameOfNewMesa(GLenum name) {
  return reinterpret_cast<const GLubyte*>(name == GL_RENDERER ? "llvmpipe (LLVM 21.1.0, 256 bits)"
                                                              : "4.5 (Core Profile) Mesa 25.3.6");
}

TEST(ProgramNotes, NameMesasThatMisnumberPrimitives) {
  const auto context = OsmesaContext::create(coreWish());
  gl::RealGl real = context->real();
  const auto noteOf = [&](Surface::Color color) {
    const GLuint program = makeProgram(real, Surface{.color = color});
    return gl::recognise(real, program, *familiesOfTests())->note;
  };
  EXPECT_EQ(noteOf(Surface::Color::cell), "");
  real.GetString = nameOfNewMesa;
  EXPECT_NE(noteOf(Surface::Color::cell).find("gl_PrimitiveID"), std::string::npos);
  EXPECT_EQ(noteOf(Surface::Color::vertex), "");
}

}  // namespace
}  // namespace gluray::test
