// An entry of the setting material.objects: what one object is made of, and which rays do not meet it. Any
// thread.
//   3 glass roughness=0.1 ior=1.4
//   7 hidden-from=camera+shadow
#pragma once
#include "settings/settings.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gluray {

/// Kinds of rays, in the order of the bits of ObjectRule::hiddenFrom.
inline constexpr std::string_view kRayWords[] = {"camera", "shadow", "occlusion", "reflection"};

struct ObjectRule {
  uint32_t object = 0;                // its number, from 1 (docs/control-protocol.md)
  bool looks = false;                 // the entry says what the object is made of
  std::optional<uint8_t> hiddenFrom;  // bit k: rays of kRayWords[k]; absent: the entry says nothing
  Settings::Material material;        // what the entry does not say is as `otherwise` has it
};

/// Reads an entry. Empty, or one line that says what is wrong with it; `rule` is then undefined.
std::string readObjectRule(std::string_view entry, const Settings::Material& otherwise, ObjectRule& rule);

/// Empty, or what is wrong with the entry.
std::string checkObjectRule(std::string_view entry);

/// The number at the beginning of an entry; 0: there is none.
uint32_t objectOf(std::string_view entry) noexcept;

/// `entries` of material.objects with what `words` say of the object: a material, KEY=VALUE. What they do not
/// name stays as it was, except that a material forgets the values that the object had, but not hidden-from.
/// "KEY=" takes the value out. No words: no entry. The entry keeps its place; a new one comes last. Words are
/// not checked: checkObjectRule() does that.
std::vector<std::string> withObject(std::vector<std::string> entries, uint32_t object,
                                    const std::vector<std::string>& words);

/// The words of the entry of an object: the material, values, hidden-from. Those of several entries are
/// merged, later ones win. Empty: there is none.
std::vector<std::string> wordsOf(const std::vector<std::string>& entries, uint32_t object);

}  // namespace gluray
