#include "pictures/cameras/xml_elements.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace gluray::launcher {
namespace {

constexpr int kDeepest = 100;

class XmlReader {
 public:
  explicit XmlReader(std::string_view text) : text_(text) {}

  XmlElement outermost() {
    skipToElement();
    if (!takes("<")) fail();
    XmlElement element = elementBehindBracket(0);
    skipToElement();
    if (at_ < text_.size()) fail();
    return element;
  }

 private:
  [[noreturn]] static void fail() { throw std::runtime_error("it is no XML"); }

  bool takes(std::string_view word) {
    if (text_.substr(at_, word.size()) != word) return false;
    at_ += word.size();
    return true;
  }
  void skipPast(std::string_view word) {
    const size_t found = text_.find(word, at_);
    if (found == text_.npos) fail();
    at_ = found + word.size();
  }
  void skipSpace() {
    while (at_ < text_.size() && std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos)
      ++at_;
  }
  /// To the next tag, or the end.
  void skipToElement() {
    for (;;) {
      at_ = std::min(text_.find('<', at_), text_.size());
      if (takes("<!--"))
        skipPast("-->");
      else if (takes("<?"))
        skipPast("?>");
      else if (takes("<!"))
        skipPast(">");
      else
        return;
    }
  }
  std::string name() {
    const size_t from = at_;
    while (at_ < text_.size() &&
           std::string_view(" \t\r\n=/<>\"'").find(text_[at_]) == std::string_view::npos)
      ++at_;
    if (at_ == from) fail();
    return std::string(text_.substr(from, at_ - from));
  }
  std::string quoted() {
    if (at_ >= text_.size() || (text_[at_] != '"' && text_[at_] != '\'')) fail();
    const char quote = text_[at_++];
    const size_t end = text_.find(quote, at_);
    if (end == text_.npos) fail();
    const std::string_view inside = text_.substr(at_, end - at_);
    at_ = end + 1;
    return plain(inside);
  }
  /// Without the five entities that XML itself has.
  static std::string plain(std::string_view text) {
    constexpr std::array<std::pair<std::string_view, char>, 5> kEntities = {
        {{"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}, {"&quot;", '"'}, {"&apos;", '\''}}};
    std::string result;
    while (!text.empty()) {
      size_t length = 1;
      char letter = text.front();
      for (const auto& [entity, meaning] : kEntities)
        if (text.starts_with(entity)) letter = meaning, length = entity.size();
      result += letter;
      text.remove_prefix(length);
    }
    return result;
  }
  XmlElement elementBehindBracket(int depth) {
    if (depth > kDeepest) fail();
    XmlElement element{.name = name()};
    for (;;) {
      skipSpace();
      if (takes("/>")) return element;
      if (takes(">")) break;
      std::string attribute = name();
      skipSpace();
      if (!takes("=")) fail();
      skipSpace();
      element.attributes[std::move(attribute)] = quoted();
    }
    for (;;) {
      skipToElement();
      if (takes("</")) {
        if (name() != element.name) fail();
        skipSpace();
        if (!takes(">")) fail();
        return element;
      }
      if (!takes("<")) fail();
      element.children.push_back(elementBehindBracket(depth + 1));
    }
  }

  std::string_view text_;
  size_t at_ = 0;
};

}  // namespace

const std::string& XmlElement::operator[](const std::string& attribute) const {
  static const std::string none;
  const auto found = attributes.find(attribute);
  return found == attributes.end() ? none : found->second;
}

const XmlElement* XmlElement::child(const std::string& tag, const std::string& attribute,
                                    const std::string& value) const {
  for (const XmlElement& one : children)
    if (one.name == tag && one[attribute] == value) return &one;
  return nullptr;
}

XmlElement readXml(std::string_view text) { return XmlReader(text).outermost(); }

}  // namespace gluray::launcher
