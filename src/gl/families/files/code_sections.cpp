#include "gl/families/files/code_sections.h"

#include "gl/families/files/family_table.h"
#include "gl/glsl/shader_digest.h"

namespace gluray::gl {
namespace {

class CodeReader : FamilyTable {
 public:
  CodeReader(const toml::table& table, const std::string& file)
      : FamilyTable(table, file, none_, noAlternatives_) {}

  void read(CodeSections& sections) {
    std::string name, statements, blocks, note;
    std::vector<std::string> written, shaders;
    text("name", name), text("statements", statements), text("blocks", blocks), text("note", note);
    texts("written", written), texts("shaders", shaders);
    bool complete = false;
    flag("complete", complete);
    if (name.empty()) fail(here(), "code needs a name");
    if (name == "any") fail(at("name"), "code cannot be named \"any\"");
    allKnown();
    KnownCode& section = sections[name];
    const size_t before = section.size();
    section.add(statements), section.addBlocks(blocks);
    for (const std::string& variable : written) section.addWritten(variable);
    for (const std::string& text : shaders) {
      const auto digest = digestIn(text);
      if (!digest) fail(at("shaders"), "\"" + text + "\" is not a digest of 32 hexadecimal digits");
      section.addShader(*digest);
    }
    if (before == 0 && section.size() == 0 && section.shaders().empty())
      fail(here(), "code \"" + name + "\" needs statements, blocks or shaders");
    if (section.note.empty()) section.note = note;
    section.complete = section.complete || complete;
  }

 private:
  Names none_;
  Alternatives noAlternatives_;
};

}  // namespace

void readCode(const toml::table& table, const std::string& file, CodeSections& sections) {
  CodeReader(table, file).read(sections);
}

void needSections(const FamilyList& list, const CodeSections& known) {
  std::string all;
  for (const auto& [name, section] : known) all += (all.empty() ? "\"" : ", \"") + name + "\"";
  for (const auto& family : list)
    for (const std::string& name : family->code)
      if (!known.contains(name))
        throw FamilyError(family->codeAt + ": there is no [[code]] section \"" + name + "\"" +
                          (all.empty() ? "" : "; there are " + all));
}

}  // namespace gluray::gl
