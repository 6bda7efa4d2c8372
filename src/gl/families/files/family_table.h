// Typed access to a TOML table of a family file. Keys that are never read are errors. Private to
// family_file.cpp and code_sections.cpp.
#pragma once
#include "gl/families/family.h"

#include <toml++/toml.h>

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gluray::gl {

/// Reads a table and its sections. Throws FamilyError with file and line on mistakes.
class FamilyTable {
 protected:
  using Names = decltype(Family::mentioned);
  /// Adds names of variables to `mentioned`, and their alternatives to `alternatives`.
  FamilyTable(const toml::table& table, const std::string& file, Names& mentioned, Alternatives& alternatives)
      : file_(file), mentioned_(mentioned), alternatives_(alternatives), table_(&table) {}

  [[noreturn]] void fail(const toml::node& at, const std::string& what) const;
  const toml::node& here() const { return *table_; }  // the section being read
  bool has(const char* key) const { return table_->contains(key); }
  const toml::node& at(const char* key) const { return *table_->get(key); }
  std::string placeOf(const toml::node& node) const;  // "FILE:LINE"

  /// A text that is not the name of a variable.
  void text(const char* key, std::string& out);
  /// Such a text, or a list of them.
  void texts(const char* key, std::vector<std::string>& out);
  /// The name of a variable, or a list of the name and its alternatives.
  void name(const char* key, std::string& out);
  /// A list of names, each of which may have alternatives, or one name.
  void names(const char* key, std::vector<std::string>& out);
  void flag(const char* key, bool& out);
  /// Records that the family mentions `name`. For an element or a component, also records the whole variable.
  void mention(const std::string& name);
  /// A uniform's name or list of alternatives, a number, or a list of numbers. A name may end with a
  /// component ("ambient.r"). A text may be a product of names ("tint * fade.a").
  void value(const char* key, FamilyValue& out);
  /// A list of uniforms' names or numbers, or one of these.
  void eachValue(const char* key, std::vector<FamilyValue>& out);
  /// A list of three uniforms' names or numbers, or one for all three.
  void values(const char* key, FamilyValue (&out)[3]);
  /// A list of uniforms' names or numbers for the lights, or one for all of them.
  void lightValues(const char* key, std::vector<FamilyValue>& out);
  /// true, false or a uniform's name.
  void flagOrName(const char* key, bool& flag, std::string& name);
  /// A section of uniforms with the values at which they have no effect.
  void neutralValues(const char* key, NeutralValues& out);
  /// A section of variables with one number each.
  void decidedValues(const char* key, DecidedValues& out);
  /// One of several words; each stands for a value.
  template <class Enum, size_t n>
  void choice(const char* key, const std::pair<const char*, Enum> (&words)[n], Enum& out) {
    std::string word;
    text(key, word);
    if (!word.empty()) out = chosen(key, words, word);
  }
  /// Such a word, or "@group": the word that programs have for a group of slots, of which `slot` takes the
  /// name.
  template <class Enum, size_t n>
  void choice(const char* key, const std::pair<const char*, Enum> (&words)[n], Enum& out, std::string& slot) {
    std::string word;
    text(key, word);
    if (word.empty()) return;
    if (word.starts_with('@')) return void(slot = word);
    slot.clear(), out = chosen(key, words, word);
  }
  /// Calls readIt() within the section, if there is one.
  template <class Read>
  void section(const char* key, Read&& readIt) {
    const toml::node* node = get(key);
    if (!node) return;
    const toml::table* inner = node->as_table();
    if (!inner) fail(*node, std::string(key) + " must be a section");
    within(*inner, readIt);
  }
  /// Calls readIt() within each section of a list of sections, [[key]].
  template <class Read>
  void eachSection(const char* key, Read&& readIt) {
    const toml::node* node = get(key);
    if (!node) return;
    const toml::array* list = node->as_array();
    if (!list || list->empty() || !list->is_homogeneous(toml::node_type::table))
      fail(*node, std::string(key) + " must be sections, [[...]]");
    for (const toml::node& item : *list) within(*item.as_table(), readIt);
  }
  /// The keys of the section.
  std::vector<std::string> keys() const;
  /// Throws if the section has a key that was not read.
  void allKnown() const;

 private:
  template <class Read>
  void within(const toml::table& inner, Read&& readIt) {
    const toml::table* outer = std::exchange(table_, &inner);
    std::set<std::string, std::less<>> known;
    known_.swap(known);
    readIt();
    allKnown();
    known_.swap(known);
    table_ = outer;
  }
  template <class Enum, size_t n>
  Enum chosen(const char* key, const std::pair<const char*, Enum> (&words)[n], const std::string& word) {
    std::string all;
    for (const auto& [name, value] : words) {
      if (word == name) return value;
      all += (all.empty() ? "" : ", ") + std::string(name);
    }
    fail(at(key), std::string(key) + " must be one of: " + all);
  }
  FamilyValue productIn(std::string_view text);
  FamilyValue valueIn(const char* key, const toml::node& node);
  std::string nameIn(const char* key, const toml::node& node);
  std::vector<float> numbersIn(const char* key, const toml::node& node, size_t most);
  const toml::node* get(const char* key);

  const std::string& file_;
  Names& mentioned_;
  Alternatives& alternatives_;
  const toml::table* table_;
  std::set<std::string, std::less<>> known_;
};

}  // namespace gluray::gl
