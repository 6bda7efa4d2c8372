#include "gl/families/files/slot_mistakes.h"

#include "gl/families/named_code.h"

#include <algorithm>
#include <map>
#include <set>

namespace gluray::gl {
namespace {

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

std::string ownSlot(const std::string& group) {
  return "fragments of the slot " + quoted(slotName(group, "")) + " have this slot themselves";
}

/// Groups of slots by the groups whose fragments have them.
using Uses = std::multimap<std::string, const KnownCode::SlotUse*>;

/// Whether fragments of `group` have slots of `wanted`, directly or by those of other groups.
bool reaches(const Uses& uses, const std::string& group, const std::string& wanted,
             std::set<std::string>& seen) {
  if (group == wanted) return true;
  if (!seen.insert(group).second) return false;
  const auto [begin, end] = uses.equal_range(group);
  return std::any_of(begin, end,
                     [&](const auto& use) { return reaches(uses, use.second->group, wanted, seen); });
}

/// `place`: of the family.
std::string mistakeInChoice(const SlotChoice& choice, const Slots& slots, const std::string& place) {
  const std::string group = choice.slot.substr(1);
  if (!isSlotName(group))
    return place + ": " + choice.key + ": " + quoted(choice.slot) + " is no name of a slot";
  const std::vector<std::string> words = slots.words(group);
  if (words.empty())
    return place + ": " + choice.key + ": the slot " + quoted(choice.slot) + " has no fragments";
  for (const std::string& word : words)
    if (!choice.has(word))
      return slots.placeOf(group, word) + ": the word " + quoted(word) + " of the slot " +
             quoted(choice.slot) + " is no value of " + choice.key;
  return "";
}

}  // namespace

std::string mistakeInUses(const KnownCode& section) {
  for (const KnownCode::SlotUse& use : section.slotUses()) {
    const std::string name = slotName(use.group, use.part);
    if (!isSlotName(use.group) || !(use.part.empty() || isSlotName(use.part)))
      return use.place + ": " + quoted(name) + " is no name of a slot";
    if (use.group == use.within) return use.place + ": " + ownSlot(use.group);
  }
  return "";
}

std::string mistakeInSlots(const Family& family, const CodeSections& known) {
  const NamedCode code(known, family.code);
  Uses uses;
  for (const KnownCode* section : code.sections())
    for (const KnownCode::SlotUse& use : section->slotUses())
      if (!use.within.empty()) uses.emplace(use.within, &use);
  for (const KnownCode* section : code.sections())
    for (const KnownCode::SlotUse& use : section->slotUses()) {
      if (!code.slots().has(use.group, use.part))
        return use.place + ": the slot " + quoted(slotName(use.group, use.part)) + " has no fragments";
      std::set<std::string> seen;
      if (!use.within.empty() && reaches(uses, use.group, use.within, seen))
        return use.place + ": " + ownSlot(use.within);
    }
  for (const SlotChoice& choice : family.slotChoices())
    if (const std::string mistake = mistakeInChoice(choice, code.slots(), family.codeAt); !mistake.empty())
      return mistake;
  return "";
}

}  // namespace gluray::gl
