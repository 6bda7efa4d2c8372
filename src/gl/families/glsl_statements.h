// GLSL as a list of statements in a normal form: without comments, white space that means nothing, and other
// ways of writing the same number. Known statements (known_code.h) are compared in this form. Any thread.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace gluray::gl {

/// Statements in normal form, in the order in which they were cut. A statement is
/// - a preprocessor directive;
/// - a declaration outside functions, or a whole function other than main;
/// - within main, what ends at a semicolon, or at the brace that closes if, else or while with all that is in
/// it;
///   of a loop "for (...) {" what is before its brace, and then what is in it.
/// Left out is what cannot change what is computed: #version, #extension, #pragma, #line, precision, and
/// plain declarations of uniforms, inputs and outputs, which the real OpenGL names and checks. Lights are
/// numbered: in a statement that speaks of one light alone ("lightColor3") its number reads "#".
class GlslStatements {
 public:
  /// A name that reads as another.
  struct Renamed {
    std::string from, to;
    bool operator==(const Renamed&) const = default;
  };
  /// Appends the statements of one shader's text.
  void cut(std::string_view text, const Renamed& renamed = {});
  /// Whether statement i stood in the same shader's text before, with the same numbers of lights.
  bool isRepeated(size_t i) const { return repeated_[i]; }
  size_t size() const { return ends_.size(); }
  /// Valid until cut() is called again.
  std::string_view operator[](size_t i) const {
    const size_t begin = i == 0 ? 0 : ends_[i - 1];
    return std::string_view(code_).substr(begin, ends_[i] - begin);
  }

 private:
  std::string code_;  // the statements, one behind the other
  std::vector<size_t> ends_;
  std::vector<bool> repeated_;
};

}  // namespace gluray::gl
