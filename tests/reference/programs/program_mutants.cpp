#include "tests/reference/programs/program_mutants.h"

#include "tests/support/drawn_image.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace gluray::test {
namespace {

struct Piece {
  size_t begin, end;
};

/// The statements of main, in order: each ends at its semicolon, or its last brace.
std::vector<Piece> piecesOf(const std::string& text) {
  std::vector<Piece> pieces;
  size_t at = text.find('{', text.find("void main()")) + 1, begin = at;
  int depth = 0, parentheses = 0;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '}' && depth == 0) break;
    parentheses += (c == '(') - (c == ')');
    depth += (c == '{') - (c == '}');
    if (depth > 0 || parentheses > 0 || (c != ';' && c != '}')) continue;
    if (text.find_first_not_of(" \n", at + 1) == text.find("else", at + 1)) continue;
    pieces.push_back({begin, at + 1});
    begin = at + 1;
  }
  return pieces;
}

const std::pair<const char*, const char*> kChanges[] = {
    {" + ", " - "},  {" * ", " + "},    {"max(", "min("},  {"-", "+"},       {"<", ">="},   {".rgb", ".bgr"},
    {"1.0", "0.25"}, {"true", "false"}, {"false", "true"}, {"== 0", "== 1"}, {"0.0", "0.5"}};

/// Whether a geometry shader may emit more vertices than it declares: Mesa then writes beyond its memory.
bool mayEmitMore(GLenum kind, const Mutant& mutant) {
  return kind == GL_GEOMETRY_SHADER && mutant.what.find("EmitVertex") != std::string::npos &&
         !mutant.what.starts_with("removed");
}

struct Drawn {
  DrawnImage image;
  uint64_t traced = 0;
};

}  // namespace

GLuint linked(Gl gl, const ShaderTexts& shaders) {
  const GLuint program = gl.CreateProgram();
  for (const auto& [kind, text] : shaders) {
    const GLuint shader = gl.CreateShader(kind);
    const char* start = text.c_str();
    gl.ShaderSource(shader, 1, &start, nullptr);
    gl.CompileShader(shader);
    gl.AttachShader(program, shader), gl.DeleteShader(shader);
  }
  gl.LinkProgram(program);
  GLint works = 0;
  gl.GetProgramiv(program, GL_LINK_STATUS, &works);
  if (works) return program;
  gl.DeleteProgram(program);
  return 0;
}

std::vector<Mutant> mutantsOf(const std::string& text) {
  std::vector<Mutant> mutants;
  const std::vector<Piece> pieces = piecesOf(text);
  for (size_t i = 0; i < pieces.size(); ++i) {
    const size_t begin = pieces[i].begin, end = pieces[i].end;
    const std::string piece = text.substr(begin, end - begin);
    const auto add = [&](const std::string& how, const std::string& instead, size_t until) {
      mutants.push_back({how + ":" + piece, text.substr(0, begin) + instead + text.substr(until)});
    };
    add("removed", "", end);
    add("twice", piece + piece, end);
    if (i + 1 < pieces.size())
      add("later", text.substr(end, pieces[i + 1].end - end) + piece, pieces[i + 1].end);
    for (const auto& [from, to] : kChanges)
      if (const size_t at = piece.find(from); at != std::string::npos)
        add(std::string(from) + "is" + to, std::string(piece).replace(at, std::string(from).size(), to), end);
  }
  return mutants;
}

void expectMutantsSeen(const std::string& name, const ShaderTexts& shaders,
                       const std::function<void(Gl, GLuint program)>& draw, const ContextWish& wish) {
  const auto real = OsmesaContext::create(wish);
  TracedContext ours(wish, TracedContext::tracing());
  const auto drawn = [&](Gl gl, const ShaderTexts& texts) {
    const GLuint program = linked(gl, texts);
    if (!program) return Drawn{};
    const uint64_t before = ours.context().counts.statistics.drawsTraced;
    draw(gl, program);
    Drawn result{readImage(gl, kProgramWidth, kProgramHeight),
                 ours.context().counts.statistics.drawsTraced - before};
    gl.UseProgram(0), gl.DeleteProgram(program);
    while (gl.GetError()) {}
    return result;
  };
  ours.makeCurrent();
  EXPECT_EQ(drawn(ours.gl(), shaders).traced, 1u) << "as they are";
  size_t compiled = 0, traced = 0;
  for (size_t s = 0; s < shaders.size(); ++s) {
    for (const Mutant& mutant : mutantsOf(shaders[s].second)) {
      if (mayEmitMore(shaders[s].first, mutant)) continue;
      ShaderTexts texts = shaders;
      texts[s].second = mutant.text;
      real->makeCurrent();
      const Drawn expected = drawn(real->real(), texts);
      if (expected.image.colors.empty()) continue;
      ours.makeCurrent();
      const Drawn got = drawn(ours.gl(), texts);
      ++compiled, traced += got.traced;
      if (!got.traced) continue;  // some use values that OpenGL leaves undefined, so are not compared
      const Comparison c = compare(expected.image, got.image, kProgramTolerance);
      EXPECT_TRUE(c.accepted) << mutant.what << "\n" << c.text;
    }
  }
  EXPECT_GT(compiled, 15u);
  EXPECT_LT(traced, compiled / 2) << "most of them compute something else";
  std::printf("%s: %zu mutants, %zu of them traced\n", name.c_str(), compiled, traced);
}

}  // namespace gluray::test
