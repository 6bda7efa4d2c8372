#include "gl/families/files/code_sections.h"

#include "gl/families/files/family_table.h"
#include "gl/families/files/slot_mistakes.h"
#include "gl/glsl/shader_digest.h"

#include <algorithm>

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
    bool wholeMain = false;
    flag("whole_main", wholeMain);
    if (name.empty()) fail(here(), "code needs a name");
    if (name == "any") fail(at("name"), "code cannot be named \"any\"");
    KnownCode& section = sections[name];
    const size_t before = section.size();
    section.add(statements, placeOf("statements"), wholeMain), section.addBlocks(blocks, placeOf("blocks"));
    eachSection("fragments", [&] { readFragments(section); });
    allKnown();
    for (const std::string& variable : written) section.addWritten(variable);
    for (const std::string& text : shaders) {
      const auto digest = digestIn(text);
      if (!digest) fail(at("shaders"), "\"" + text + "\" is not a digest of 32 hexadecimal digits");
      section.addShader(*digest);
    }
    if (before == 0 && section.size() == 0 && section.shaders().empty() &&
        section.fragments().groups().empty())
      fail(here(), "code \"" + name + "\" needs statements, blocks, fragments or shaders");
    if (const std::string mistake = mistakeInUses(section); !mistake.empty()) throw FamilyError(mistake);
    if (section.note.empty()) section.note = note;
    section.complete = section.complete || complete;
  }

 private:
  std::string placeOf(const char* key) const { return has(key) ? FamilyTable::placeOf(at(key)) : ""; }

  /// A word of a group of slots with its fragments: "text" is that of "@group", other keys are parts.
  void readFragments(KnownCode& section) {
    std::string group, word;
    text("slot", group), text("word", word);
    if (!isSlotName(group)) fail(here(), "fragments need a slot, a name of letters, digits and _");
    if (word.empty()) fail(here(), "fragments need a word");
    section.addWord(group, word, placeOf("word"));
    bool required = false;
    flag("required", required);
    if (required) section.requireWord(group);
    for (const std::string& key : keys()) {
      if (key == "slot" || key == "word" || key == "required") continue;
      if (!isSlotName(key)) fail(at(key.c_str()), "\"" + key + "\" is no name of a part of a slot");
      std::string fragment;
      text(key.c_str(), fragment);
      section.addFragment(group, word, key == "text" ? "" : key, fragment, placeOf(key.c_str()));
    }
  }

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
  for (const auto& family : list)
    if (const std::string mistake = mistakeInSlots(*family, known); !mistake.empty())
      throw FamilyError(mistake);
}

void needSlots(const FamilyList& list, const CodeSections& more, const CodeSections& known) {
  for (const auto& family : list) {
    const bool changed =
        std::ranges::any_of(family->code, [&](const std::string& name) { return more.contains(name); });
    if (!changed) continue;
    if (const std::string mistake = mistakeInSlots(*family, known); !mistake.empty())
      throw FamilyError(mistake);
  }
}

}  // namespace gluray::gl
