#include "gl/families/family.h"

#include <algorithm>

namespace gluray::gl {

namespace {

template <class Enum, size_t n>
std::vector<std::string> wordsOf(const std::pair<const char*, Enum> (&words)[n]) {
  std::vector<std::string> all;
  for (const auto& [word, value] : words) all.emplace_back(word);
  return all;
}

}  // namespace

bool SlotChoice::has(std::string_view word) const { return std::ranges::find(words, word) != words.end(); }

std::vector<SlotChoice> Family::slotChoices() const {
  std::vector<SlotChoice> all;
  const auto add = [&](const char* key, const std::string& slot, const auto& words) {
    if (!slot.empty()) all.push_back({key, slot, wordsOf(words)});
  };
  add("volume.blend", volume.blendSlot, kVolumeBlends);
  add("volume.channels", volume.channelsSlot, kVolumeChannels);
  add("volume.lighting", volume.light.modelSlot, kVolumeLightings);
  add("volume.clip_space", volume.clipSlot, kVolumeClipSpaces);
  add("volume.component", volume.levels.componentSlot, kVolumeComponents);
  add("volume.depth_shown", volume.span.depthSlot, kVolumeDepths);
  return all;
}

bool Family::hasBuiltInVertices() const { return position == "gl_Vertex"; }

bool Family::mentions(std::string_view name) const {
  if (mentioned.contains(name)) return true;
  // "lightColor12" is mentioned as "lightColor{}".
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  for (size_t digit = 0, end = 0; digit < name.size(); digit = end + 1) {
    digit = std::min(name.find_first_of("0123456789", digit), name.size());
    for (end = digit; end < name.size() && isDigit(name[end]);) ++end;
    std::string pattern(name.substr(0, digit));
    pattern += "{}";
    pattern += name.substr(end);
    if (end > digit && mentioned.contains(pattern)) return true;
  }
  return false;
}

void FamilyList::append(const FamilyList& more) {
  families.insert(families.end(), more.families.begin(), more.families.end());
  for (const auto& [name, known] : more.code) code[name].add(known);
}

}  // namespace gluray::gl
