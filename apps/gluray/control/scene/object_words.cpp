#include "control/scene/object_words.h"

#include "base/number_text.h"
#include "settings/object_rule.h"

#include <algorithm>
#include <string_view>
#include <unordered_set>

namespace gluray::launcher {
namespace {

bool startsWithDigit(std::string_view word) { return !word.empty() && word[0] >= '0' && word[0] <= '9'; }

bool readObjectNumber(std::string_view text, uint32_t& number) {
  return readNumber(text, number) && number > 0;
}

}  // namespace

bool ObjectChoice::has(uint32_t object) const {
  return all || std::any_of(ranges.begin(), ranges.end(), [&](const auto& range) {
           return object >= range.first && object <= range.second;
         });
}

std::string takeObjects(std::vector<std::string>& words, ObjectChoice& choice) {
  auto word = words.begin();
  for (; word != words.end() && (*word == "all" || startsWithDigit(*word)); ++word) {
    if (*word == "all") {
      choice.all = true;
      continue;
    }
    const std::string_view text = *word;
    const size_t dash = text.find('-');
    std::pair<uint32_t, uint32_t> range;
    const bool first = readObjectNumber(text.substr(0, dash), range.first);
    range.second = range.first;
    if (!first || (dash != text.npos && !readObjectNumber(text.substr(dash + 1), range.second)) ||
        range.second < range.first)
      return word->substr(0, 40) + ": objects are numbers from 1, such as 3, or ranges, such as 5-7";
    choice.ranges.push_back(range);
  }
  words.erase(words.begin(), word);
  return "";
}

std::vector<uint32_t> chosenObjects(const ObjectChoice& choice, const std::vector<uint32_t>& objects,
                                    uint32_t& missing) {
  missing = 0;
  std::unordered_set<uint32_t> there;
  std::vector<uint32_t> chosen;
  for (const uint32_t object : objects)
    if (there.insert(object).second && choice.has(object)) chosen.push_back(object);
  for (const auto& [first, last] : choice.ranges)
    if (missing == 0 && first == last && !there.contains(first)) missing = first;
  return chosen;
}

std::string problemOfWords(const std::vector<std::string>& words) {
  const std::string front = "object 1: ";
  std::string entry = "1";
  for (const std::string& word : words) {
    if (word.find_first_of(" ,") != word.npos) return word.substr(0, 40) + ": use one word a value";
    entry.append(" ").append(word);
  }
  const std::string why = checkObjectRule(entry);
  return why.starts_with(front) ? why.substr(front.size()) : why;
}

}  // namespace gluray::launcher
