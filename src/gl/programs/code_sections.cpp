#include "gl/programs/code_sections.h"

#include "gl/programs/family_table.h"

namespace gluray::gl {
namespace {

class CodeReader : FamilyTable {
 public:
  CodeReader(const toml::table& table, const std::string& file) : FamilyTable(table, file, none_) {}

  void read(CodeSections& sections) {
    std::string name, statements;
    text("name", name), text("statements", statements);
    if (name.empty()) fail(here(), "code needs a name");
    if (name == "any") fail(at("name"), "code cannot be named \"any\"");
    if (statements.empty()) fail(here(), "code \"" + name + "\" needs statements");
    allKnown();
    sections[name].add(statements);
  }

 private:
  Names none_;
};

}  // namespace

void readCode(const toml::table& table, const std::string& file, CodeSections& sections) {
  CodeReader(table, file).read(sections);
}

void FamilyList::append(const FamilyList& more) {
  families.insert(families.end(), more.families.begin(), more.families.end());
  for (const auto& [name, known] : more.code) code[name].add(known);
}

}  // namespace gluray::gl
