// An entry of the setting material.objects: the material of one object, and the rays that it is hidden from.
// Any thread.
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

/// The parsed entry.
struct ObjectRule {
  uint32_t object = 0;                // number of the object, from 1 (docs/control-protocol.md)
  bool looks = false;                 // the entry specifies a material or a value of it
  std::optional<uint8_t> hiddenFrom;  // bit k: rays of kRayWords[k]; nullopt if the entry does not specify it
  Settings::Material material;        // unspecified values are those of `otherwise`
};

/// Parses an entry into `rule`. Returns a one-line error message and leaves `rule` undefined, or an empty
/// string. `otherwise`: values that the entry does not specify.
std::string readObjectRule(std::string_view entry, const Settings::Material& otherwise, ObjectRule& rule);

/// An error message for the entry; empty if it is valid.
std::string checkObjectRule(std::string_view entry);

/// The object number at the beginning of an entry; 0 if there is none.
uint32_t objectOf(std::string_view entry) noexcept;

/// Returns `entries` of material.objects with `words` applied to the object: a material, KEY=VALUE. Other
/// values stay as they were, except that a material resets the object's values, but not hidden-from. "KEY="
/// removes the value. Without words, the entry is removed. The entry keeps its place; a new one is added at
/// the end. Words are not checked: call checkObjectRule().
std::vector<std::string> withObject(std::vector<std::string> entries, uint32_t object,
                                    const std::vector<std::string>& words);

/// The words of an object's entry: material, values, hidden-from. If there are several entries, they are
/// merged, and later ones win. Empty if there is none.
std::vector<std::string> wordsOf(const std::vector<std::string>& entries, uint32_t object);

}  // namespace gluray
