// Reads the XML that ParaView writes: elements with attributes, comments, no text. Any thread.
#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace gluray::launcher {

struct XmlElement {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::vector<XmlElement> children;

  /// The attribute's value; empty: it has none.
  const std::string& operator[](const std::string& attribute) const;
  /// The first child with this name and this attribute; null: none.
  const XmlElement* child(const std::string& tag, const std::string& attribute,
                          const std::string& value) const;
};

/// The file's outermost element. Texts between elements are left out. Throws std::runtime_error with one line
/// if it is no XML, or nested deeper than 100 elements.
XmlElement readXml(std::string_view text);

}  // namespace gluray::launcher
