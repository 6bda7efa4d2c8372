#include "gl/families/slot_fragments.h"

#include <algorithm>

namespace gluray::gl {

SlotWord& SlotFragments::entry(std::string_view group, std::string_view word) {
  std::vector<SlotWord>& words = groups_[std::string(group)];
  const auto found = std::ranges::find(words, word, &SlotWord::word);
  return found != words.end() ? *found : words.emplace_back(SlotWord{std::string(word), "", {}});
}

void SlotFragments::addWord(std::string_view group, std::string_view word, const std::string& place) {
  SlotWord& known = entry(group, word);
  if (known.place.empty()) known.place = place;
}

void SlotFragments::addFragment(std::string_view group, std::string_view word, const std::string& part,
                                const PatternText& text) {
  std::vector<PatternText>& texts = entry(group, word).parts[part];
  if (std::ranges::find(texts, text.text(), &PatternText::text) == texts.end()) texts.push_back(text);
}

void SlotFragments::add(const SlotFragments& more) {
  required_.insert(more.required_.begin(), more.required_.end());
  for (const auto& [group, words] : more.groups_)
    for (const SlotWord& word : words) {
      addWord(group, word.word, word.place);
      for (const auto& [part, texts] : word.parts)
        for (const PatternText& text : texts) addFragment(group, word.word, part, text);
    }
}

bool Slots::has(std::string_view group, std::string_view part) const {
  bool found = false;
  findFragment(group, part, [&](const PatternText&) { return found = true; });
  return found;
}

std::vector<std::string> Slots::words(std::string_view group) const {
  std::vector<std::string> all;
  for (const SlotFragments* section : sections_) {
    const auto words = section->groups().find(group);
    if (words == section->groups().end()) continue;
    for (const SlotWord& word : words->second)
      if (std::ranges::find(all, word.word) == all.end()) all.push_back(word.word);
  }
  return all;
}

std::string Slots::placeOf(std::string_view group, std::string_view word) const {
  for (const SlotFragments* section : sections_)
    if (const auto words = section->groups().find(group); words != section->groups().end())
      if (const auto known = std::ranges::find(words->second, word, &SlotWord::word);
          known != words->second.end())
        return known->place;
  return "";
}

std::vector<std::string> Slots::wordsWith(std::string_view group, std::string_view part,
                                          std::string_view text) const {
  std::map<std::string_view, bool> fits;  // of words with fragments of the part
  for (const SlotFragments* section : sections_) {
    const auto words = section->groups().find(group);
    if (words == section->groups().end()) continue;
    for (const SlotWord& word : words->second)
      if (const auto texts = word.parts.find(part); texts != word.parts.end())
        fits[word.word] |= std::ranges::find(texts->second, text, &PatternText::text) != texts->second.end();
  }
  std::vector<std::string> found;
  for (std::string& word : words(group)) {
    const auto known = fits.find(word);
    if (known == fits.end() ? text.empty() : known->second) found.push_back(std::move(word));
  }
  const auto needs = [&](const SlotFragments* section) { return section->isRequired(group); };
  if (text.empty() && std::ranges::none_of(sections_, needs)) found.emplace_back();
  return found;
}

}  // namespace gluray::gl
