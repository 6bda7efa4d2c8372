// The words of gluray material: objects, then a material and values. Pure functions; any thread.
#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace gluray::launcher {

/// What the user typed: "3", "5-7", "all".
struct ObjectChoice {
  std::vector<std::pair<uint32_t, uint32_t>> ranges;  // first and last number, from 1
  bool all = false;

  bool empty() const { return ranges.empty() && !all; }
  bool has(uint32_t object) const;
};

/// The words in front that name objects; takes them out of `words`. Empty, or one line that says what is
/// wrong.
std::string takeObjects(std::vector<std::string>& words, ObjectChoice& choice);

/// Those of `objects` that are chosen, each once, in their order. `missing`: the first number that the user
/// typed alone and that is none of `objects`; 0: none.
std::vector<uint32_t> chosenObjects(const ObjectChoice& choice, const std::vector<uint32_t>& objects,
                                    uint32_t& missing);

/// What is wrong with the words of an entry, such as "glass" and "roughness=2"; empty: nothing.
std::string problemOfWords(const std::vector<std::string>& words);

}  // namespace gluray::launcher
