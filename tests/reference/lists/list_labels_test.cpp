// glObjectLabel and glGetObjectLabel of display lists and other objects: texts, lengths and errors are those
// of the real OpenGL.
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace gluray::test {
namespace {

using Gl = const gl::RealGl&;

/// What glGetObjectLabel writes into `size` characters, and its error.
std::string labelOf(Gl gl, GLenum kind, GLuint name, GLsizei size = 64) {
  GLchar text[64] = "untouched";
  GLsizei length = -1;
  gl.GetObjectLabel(kind, name, size, &length, text);
  std::ostringstream out;
  out << text << ' ' << length << " error " << std::hex << gl.GetError() << '\n';
  return out.str();
}

std::string lengthOf(Gl gl, GLenum kind, GLuint name) {
  GLsizei length = -1;
  gl.GetObjectLabel(kind, name, 64, &length, nullptr);
  return "length " + std::to_string(length) + '\n';
}

std::string errorOf(Gl gl) { return "error " + std::to_string(gl.GetError()) + '\n'; }

void emptyList(Gl gl, GLuint name) { gl.NewList(name, GL_COMPILE), gl.EndList(); }

struct LabelCase {
  const char* name;
  std::string (*transcript)(Gl gl);
};
void PrintTo(const LabelCase& c, std::ostream* out) { *out << c.name; }

const LabelCase kLabelCases[] = {
    {"Lists",
     [](Gl gl) {
       emptyList(gl, 7);
       std::string out = labelOf(gl, GL_DISPLAY_LIST, 7) + lengthOf(gl, GL_DISPLAY_LIST, 7);
       gl.ObjectLabel(GL_DISPLAY_LIST, 7, -1, "whole text"), out += errorOf(gl);
       out += labelOf(gl, GL_DISPLAY_LIST, 7) + lengthOf(gl, GL_DISPLAY_LIST, 7);
       gl.ObjectLabel(GL_DISPLAY_LIST, 7, 5, "first five"), out += labelOf(gl, GL_DISPLAY_LIST, 7);
       for (const GLsizei size : {1, 5, 6}) out += labelOf(gl, GL_DISPLAY_LIST, 7, size);
       gl.ObjectLabel(GL_DISPLAY_LIST, 7, 0, nullptr), out += labelOf(gl, GL_DISPLAY_LIST, 7);
       return out;
     }},
    {"GeneratedLists",
     [](Gl gl) {
       const GLuint first = gl.GenLists(2);
       gl.ObjectLabel(GL_DISPLAY_LIST, first + 1, -1, "second");
       std::string out =
           errorOf(gl) + labelOf(gl, GL_DISPLAY_LIST, first) + labelOf(gl, GL_DISPLAY_LIST, first + 1);
       gl.DeleteLists(first, 2);
       return out + labelOf(gl, GL_DISPLAY_LIST, first + 1);
     }},
    {"DeletedAndMadeAgain",
     [](Gl gl) {
       emptyList(gl, 3);
       gl.ObjectLabel(GL_DISPLAY_LIST, 3, -1, "gone");
       gl.DeleteLists(3, 1), emptyList(gl, 3);
       return labelOf(gl, GL_DISPLAY_LIST, 3);
     }},
    {"CompiledAgain",
     [](Gl gl) {
       emptyList(gl, 5);
       gl.ObjectLabel(GL_DISPLAY_LIST, 5, -1, "before");
       emptyList(gl, 5);
       return labelOf(gl, GL_DISPLAY_LIST, 5);
     }},
    {"Errors",
     [](Gl gl) {
       gl.ObjectLabel(GL_DISPLAY_LIST, 99, -1, "no such list");
       std::string out = errorOf(gl) + labelOf(gl, GL_DISPLAY_LIST, 99);
       emptyList(gl, 4);
       GLint most = 0;
       gl.GetIntegerv(GL_MAX_LABEL_LENGTH, &most);
       const std::string longest(static_cast<size_t>(most) - 1, 'x'), longer = longest + "x";
       gl.ObjectLabel(GL_DISPLAY_LIST, 4, -1, longer.c_str()), out += errorOf(gl);
       gl.ObjectLabel(GL_DISPLAY_LIST, 4, most, longer.c_str()), out += errorOf(gl);
       gl.ObjectLabel(GL_DISPLAY_LIST, 4, -1, longest.c_str()), out += errorOf(gl);
       out += lengthOf(gl, GL_DISPLAY_LIST, 4) + labelOf(gl, GL_DISPLAY_LIST, 4, -1);
       gl.ObjectLabel(GL_LINES, 4, -1, "no such kind"), out += errorOf(gl);
       return out;
     }},
    {"WhileAListIsCompiled",
     [](Gl gl) {
       emptyList(gl, 5);
       gl.NewList(6, GL_COMPILE), gl.ObjectLabel(GL_DISPLAY_LIST, 5, -1, "at once");
       std::string out = labelOf(gl, GL_DISPLAY_LIST, 5);
       gl.EndList();
       return out + labelOf(gl, GL_DISPLAY_LIST, 5);
     }},
    {"Textures",
     [](Gl gl) {
       GLuint texture = 0;
       gl.GenTextures(1, &texture), gl.BindTexture(GL_TEXTURE_2D, texture);
       gl.ObjectLabel(GL_TEXTURE, texture, -1, "a texture");
       return errorOf(gl) + labelOf(gl, GL_TEXTURE, texture) + labelOf(gl, GL_TEXTURE, 12345);
     }},
};

class ListLabels : public testing::TestWithParam<LabelCase> {};

TEST_P(ListLabels, AreThoseOfTheRealOpenGl) {
  const std::string expected = [] {
    const auto real = OsmesaContext::create({});
    return GetParam().transcript(real->real());
  }();
  const TracedContext ours;
  EXPECT_EQ(GetParam().transcript(ours.gl()), expected);
}

/// Mesa 22.3 reads as many characters as it is told to.
TEST(ListLabel, IsNotReadIfItIsTooLong) {
  const TracedContext ours;
  emptyList(ours.gl(), 4);
  ours.gl().ObjectLabel(GL_DISPLAY_LIST, 4, 1 << 30, "shorter than that");
  EXPECT_EQ(ours.gl().GetError(), static_cast<GLenum>(GL_INVALID_VALUE));
  EXPECT_EQ(labelOf(ours.gl(), GL_DISPLAY_LIST, 4), " 0 error 0\n");
}

INSTANTIATE_TEST_SUITE_P(All, ListLabels, testing::ValuesIn(kLabelCases),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace gluray::test
