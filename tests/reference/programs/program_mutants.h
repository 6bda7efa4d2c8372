// Programs that differ from others in one statement of a shader's main.
#pragma once
#include "tests/reference/programs/program_stage.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace gluray::test {

/// The kinds and texts of a program's shaders.
using ShaderTexts = std::vector<std::pair<GLenum, std::string>>;

/// Compiles and links; 0 if that fails.
GLuint linked(Gl gl, const ShaderTexts& shaders);

struct Mutant {
  std::string what;  // description of the change
  std::string text;
};
/// `text` with each statement of main removed, written twice, exchanged with the next one, and changed in
/// each of several ways.
std::vector<Mutant> mutantsOf(const std::string& text);

/// Draws each mutant of each shader that can be linked by the real OpenGL and through ours, and expects the
/// same image. The unchanged program must be traced, and only few mutants: those that change nothing.
void expectMutantsSeen(const std::string& name, const ShaderTexts& shaders,
                       const std::function<void(Gl, GLuint program)>& draw,
                       const ContextWish& wish = coreWish());

}  // namespace gluray::test
