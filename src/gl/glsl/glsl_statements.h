// Cuts GLSL into statements in a normal form: no comments, no needless white space, one spelling per number.
// Known statements (known_code.h) are compared in this form. Any thread.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace gluray::gl {

/// Statements in normal form, in the order of the text. A statement is
/// - a preprocessor directive;
/// - a declaration outside functions, or a whole function other than main;
/// - in main, a statement up to its semicolon, or a whole if, else or while up to its closing brace;
///   of a loop, its head "for (...) {", and then each statement of its body.
/// Statements that do not affect the result are omitted: #version, #extension, #pragma, #line, precision, and
/// plain declarations of uniforms, inputs and outputs, which the real OpenGL names and checks. In a statement
/// that names only one light ("lightColor3"), the light's number becomes "#".
class GlslStatements {
 public:
  /// Replaces the name `from` by `to`.
  struct Renamed {
    std::string from, to;
    bool operator==(const Renamed&) const = default;
  };
  /// How a text is cut.
  struct How {
    bool used = false;  // without functions and constants outside functions whose names occur nowhere else
    bool wholeMain = false;  // main is one statement, as other functions
  };
  /// Appends the statements of one shader's text.
  void cut(std::string_view text, const Renamed& renamed = {}, const How& how = {false, false});
  /// Takes the statements away whose element is true.
  void drop(const std::vector<bool>& unwanted) { drop(unwanted, 0); }
  /// Whether statement i occurred earlier in the same shader's text, with the same light numbers.
  bool isRepeated(size_t i) const { return repeated_[i]; }
  size_t size() const { return ends_.size(); }
  /// Valid until cut() is called again.
  std::string_view operator[](size_t i) const {
    const size_t begin = i == 0 ? 0 : ends_[i - 1];
    return std::string_view(code_).substr(begin, ends_[i] - begin);
  }

 private:
  void dropUnused(size_t first, const std::vector<bool>& global);
  void drop(const std::vector<bool>& unused, size_t first);
  std::string code_;  // the concatenated statements
  std::vector<size_t> ends_;
  std::vector<bool> repeated_;
};

/// The name that a statement outside functions defines or declares, if it is a function or a constant;
/// otherwise empty.
std::string_view definedBy(std::string_view statement);

/// Calls each(word) for every name and number of a statement.
template <class Each>
void eachWord(std::string_view s, Each&& each) {
  const auto isPart = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  for (size_t at = 0; at < s.size();) {
    size_t end = at;
    while (end < s.size() && isPart(s[end])) ++end;
    if (end > at) each(s.substr(at, end - at));
    at = end > at ? end : at + 1;
  }
}

/// A part of a function in the normal form that it has within a statement.
std::string normalForm(std::string_view text);

}  // namespace gluray::gl
