// Fragments of text that programs compose their shaders from. A group of slots has words, and each word has
// its own fragments for the parts of the group. Part of known code (known_code.h). Any thread.
#pragma once
#include "gl/families/pattern_text.h"

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gluray::gl {

/// Words of a shader program by the groups of slots, with "@". The word of a group whose slots are all empty
/// is "".
using SlotWords = std::map<std::string, std::string, std::less<>>;

/// The value, of those that words stand for, that the word of the group `slot` ("@group") stands for;
/// `otherwise` if there is none.
template <class Value, size_t n>
Value valueOfWord(const SlotWords& words, std::string_view slot,
                  const std::pair<const char*, Value> (&values)[n], Value otherwise) {
  if (const auto word = words.find(slot); word != words.end())
    for (const auto& [name, value] : values)
      if (word->second == name) return value;
  return otherwise;
}

/// A word with the alternative fragments of each part. Parts that it lacks are empty in its programs.
struct SlotWord {
  std::string word;
  std::string place;  // where it is named first, for mistakes
  std::map<std::string, std::vector<PatternText>, std::less<>> parts;
};

/// The groups of one section of known code.
class SlotFragments {
 public:
  void addWord(std::string_view group, std::string_view word, const std::string& place = "");
  void addFragment(std::string_view group, std::string_view word, const std::string& part,
                   const PatternText& text);
  /// Programs have one of the group's words: slots that are all empty are not enough.
  void require(std::string_view group) { required_.emplace(group); }
  void add(const SlotFragments& more);
  bool isRequired(std::string_view group) const { return required_.contains(group); }
  const std::map<std::string, std::vector<SlotWord>, std::less<>>& groups() const { return groups_; }

 private:
  SlotWord& entry(std::string_view group, std::string_view word);
  std::map<std::string, std::vector<SlotWord>, std::less<>> groups_;
  std::set<std::string, std::less<>> required_;
};

/// The groups of several sections, used together. Refers to the sections' fragments.
class Slots {
 public:
  void add(const SlotFragments& section) { sections_.push_back(&section); }
  /// Calls each(fragment) for the fragments of a slot until one of the calls returns true.
  template <class Each>
  void findFragment(std::string_view group, std::string_view part, Each&& each) const {
    for (const SlotFragments* section : sections_) {
      const auto words = section->groups().find(group);
      if (words == section->groups().end()) continue;
      for (const SlotWord& word : words->second) {
        const auto texts = word.parts.find(part);
        if (texts == word.parts.end()) continue;
        for (const PatternText& text : texts->second)
          if (each(text)) return;
      }
    }
  }
  bool has(std::string_view group, std::string_view part) const;
  /// The group's words in the order of the files, without "".
  std::vector<std::string> words(std::string_view group) const;
  /// Where a word of the group is named first.
  std::string placeOf(std::string_view group, std::string_view word) const;
  /// Those that have `text` at `part`, and last "" if it is empty and the group is not required.
  std::vector<std::string> wordsWith(std::string_view group, std::string_view part,
                                     std::string_view text) const;

 private:
  std::vector<const SlotFragments*> sections_;
};

}  // namespace gluray::gl
