#include "base/toml_text.h"

#include "base/ample_stack.h"

#include <cstddef>
#include <string>

namespace gluray {
namespace {

bool beginsKey(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '-' ||
         c == '"' || c == '\'' || (c & 0x80) != 0;
}

/// Scans the strings, comments and arrays of a text.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  /// The line, from 1, of the first table header without a key, key without a value, or closing bracket
  /// without an opening one; 0 if there is none.
  size_t lineOfGap() {
    for (bool first = true; at_ < text_.size(); ++at_) {  // first: only blanks so far on this line
      const char c = text_[at_];
      if (c == '\n') ++line_, first = true;
      if (c == '\n' || c == ' ' || c == '\t' || c == '\r') continue;
      if (c == '#') skipLine();
      if (c == '"' || c == '\'') skipString(c);
      if (c == '=' && !valueFollows()) return line_;
      if (c == '[' && first && open_.empty()) {
        if (!headerHasKey()) return line_;
        skipLine();
      } else if (c == '[' || c == '{') {
        open_ += c;
      } else if (c == ']' || c == '}') {
        if (open_.empty() || open_.back() != (c == ']' ? '[' : '{')) return line_;
        open_.pop_back();
      }
      first = false;
    }
    return 0;
  }

 private:
  bool startsWith(std::string_view what) const { return text_.substr(at_, what.size()) == what; }
  void skipLine() {
    while (at_ + 1 < text_.size() && text_[at_ + 1] != '\n') ++at_;
  }
  /// Moves to the last character of the string.
  void skipString(char quote) {
    const std::string three(3, quote);
    const bool lines = startsWith(three);
    at_ += lines ? 3 : 1;
    for (; at_ < text_.size(); ++at_) {
      if (text_[at_] == '\n') ++line_;
      if (text_[at_] == '\\' && quote == '"') {
        ++at_;
      } else if (lines ? startsWith(three) : text_[at_] == quote) {
        at_ += lines ? 2 : 0;
        return;
      }
    }
  }
  bool headerHasKey() {
    if (startsWith("[[")) ++at_;
    while (at_ + 1 < text_.size() && (text_[at_ + 1] == ' ' || text_[at_ + 1] == '\t')) ++at_;
    return at_ + 1 < text_.size() && beginsKey(text_[at_ + 1]);
  }

  bool valueFollows() const {
    const size_t value = text_.find_first_not_of(" \t", at_ + 1);
    return value != text_.npos && std::string_view("\r\n]},#=").find(text_[value]) == std::string_view::npos;
  }

  std::string_view text_;
  size_t at_ = 0, line_ = 1;
  std::string open_;  // open brackets at this position
};

}  // namespace

toml::table parseToml(std::string_view text, std::string_view file) {
  if (const size_t line = Scanner(text).lineOfGap()) {
    const toml::source_position place{static_cast<toml::source_index>(line), 1};
    throw toml::parse_error("a name, a value or a bracket is missing",
                            toml::source_region{place, place, nullptr});
  }
  return onAmpleStack([&] { return toml::table(toml::parse(text, file)); });
}

}  // namespace gluray
