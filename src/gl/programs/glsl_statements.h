// GLSL as a list of statements in a normal form: without comments, white space that means nothing, and other
// ways of writing the same number. Known statements (known_code.h) are compared in this form. Any thread.
#pragma once
#include <span>
#include <string_view>
#include <vector>

namespace gluray::gl {

/// Brings one shader's text into the normal form, in place, and appends its statements to `statements`, views
/// of `text`. A statement is
/// - a preprocessor directive;
/// - a declaration outside functions, or a whole function other than main;
/// - within main, what ends at a semicolon, or at the brace that closes if, else or while with all that is in
/// it;
///   of a loop "for (...) {" what is before its brace, and then what is in it.
/// Left out is what cannot change what is computed: #version, #extension, #pragma, #line, precision, and
/// plain declarations of uniforms, inputs and outputs, which the real OpenGL names and checks. Lights are
/// numbered: in a statement that speaks of one light alone ("lightColor3") its number reads "#". Allocates
/// nothing but what `statements` does.
void cutStatements(std::span<char> text, std::vector<std::string_view>& statements);

}  // namespace gluray::gl
