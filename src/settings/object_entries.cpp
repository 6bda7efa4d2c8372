#include "settings/object_entries.h"

#include "settings/object_rule.h"

#include <algorithm>
#include <utility>

namespace gluray {
namespace {

constexpr std::string_view kHidden = "hidden-from";

/// The key that a word sets; empty for a material.
std::string_view keyOf(std::string_view word) {
  const size_t equals = word.find('=');
  return equals == word.npos ? "" : word.substr(0, equals);
}

/// Position in an entry: 0 for the material, 1 for values, 2 for hidden-from.
int placeOf(std::string_view word) {
  const std::string_view key = keyOf(word);
  return key.empty() ? 0 : key == kHidden ? 2 : 1;
}

/// Replaces the word with the same key; otherwise inserts the word after those that precede it in an entry.
void merge(std::vector<std::string>& words, const std::string& word) {
  const auto old = std::find_if(words.begin(), words.end(),
                                [&](const std::string& known) { return keyOf(known) == keyOf(word); });
  if (old != words.end()) {
    *old = word;
    return;
  }
  const auto behind = std::find_if(words.begin(), words.end(),
                                   [&](const std::string& known) { return placeOf(known) > placeOf(word); });
  words.insert(behind, word);
}

/// The words of an entry after its number.
std::vector<std::string> wordsBehindNumber(std::string_view entry) {
  std::vector<std::string> words;
  for (size_t begin = entry.find_first_not_of(' '); begin < entry.size();
       begin = entry.find_first_not_of(' ', begin)) {
    const size_t end = std::min(entry.find(' ', begin), entry.size());
    words.emplace_back(entry.substr(begin, end - begin));
    begin = end;
  }
  if (!words.empty()) words.erase(words.begin());
  return words;
}

}  // namespace

std::vector<std::string> wordsOf(const std::vector<std::string>& entries, uint32_t object) {
  std::vector<std::string> words;
  for (const std::string& entry : entries)
    if (object != 0 && objectOf(entry) == object)
      for (const std::string& word : wordsBehindNumber(entry)) merge(words, word);
  return words;
}

std::vector<std::string> withObject(std::vector<std::string> entries, uint32_t object,
                                    const std::vector<std::string>& words) {
  std::vector<std::string> merged = words.empty() ? words : wordsOf(entries, object);
  if (std::any_of(words.begin(), words.end(), [](const std::string& word) { return placeOf(word) == 0; }))
    std::erase_if(merged, [](const std::string& word) { return placeOf(word) != 2; });
  for (const std::string& word : words) merge(merged, word);
  std::erase_if(merged, [](const std::string& word) { return word.ends_with('='); });

  std::string entry = std::to_string(object);
  for (const std::string& word : merged) entry += " " + word;
  const auto ofObject = [&](const std::string& known) { return objectOf(known) == object; };
  const auto old = std::find_if(entries.begin(), entries.end(), ofObject);
  const auto place = old - entries.begin();
  entries.erase(std::remove_if(old, entries.end(), ofObject), entries.end());
  if (!merged.empty()) entries.insert(entries.begin() + place, entry);
  return entries;
}

ObjectEntries::ObjectEntries(const std::vector<std::string>& entries) {
  for (const std::string& entry : entries) {
    const uint32_t object = objectOf(entry);
    const auto [place, isNew] = entries_.try_emplace(object);
    if (isNew) order_.push_back(object);
    place->second.push_back(entry);
  }
}

std::vector<std::string> ObjectEntries::words(uint32_t object) const {
  const auto found = entries_.find(object);
  return found == entries_.end() ? std::vector<std::string>() : wordsOf(found->second, object);
}

void ObjectEntries::change(uint32_t object, const std::vector<std::string>& words) {
  const auto [place, isNew] = entries_.try_emplace(object);
  if (isNew) order_.push_back(object);
  place->second = withObject(std::move(place->second), object, words);
}

std::vector<std::string> ObjectEntries::all() const {
  std::vector<std::string> result;
  for (const uint32_t object : order_) {
    const std::vector<std::string>& own = entries_.at(object);
    result.insert(result.end(), own.begin(), own.end());
  }
  return result;
}

}  // namespace gluray
