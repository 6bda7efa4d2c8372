#include "control/scene/material.h"

#include "base/printable.h"
#include "control/messages/value.h"
#include "control/scene/object_words.h"
#include "control/scene/objects.h"
#include "control/values/change.h"
#include "say.h"
#include "settings/object_entries.h"
#include "settings/object_rule.h"

#include <algorithm>
#include <iostream>

namespace gluray::launcher {
namespace {

using nlohmann::json;
using Entries = std::vector<std::string>;

constexpr size_t kMaxValueBytes = size_t{16} << 10;  // bytes that programs take (docs/control-protocol.md)

/// What the user asks for.
struct MaterialChange {
  ObjectChoice objects;
  Entries words;  // of entries; for --show, these are not known yet
  bool show = false, reset = false;

  bool changes() const { return !words.empty() || show || reset; }
};

std::string readMaterialChange(const ControlOptions& options, MaterialChange& change) {
  change.words = options.words;
  change.show = options.show, change.reset = options.reset;
  if (std::string why = takeObjects(change.words, change.objects); !why.empty()) return why;
  if (options.reset && !change.words.empty()) return "--reset takes objects alone";
  if (options.hide) change.words.push_back("hidden-from=all");
  if (!options.hideFrom.empty()) change.words.push_back("hidden-from=" + options.hideFrom);
  if (std::string why = problemOfWords(change.words); !why.empty()) return why;
  const bool nothing = change.changes() && change.objects.empty();
  return nothing ? "no object given; use gluray material 3 glass, or all for all objects" : "";
}

Entries entriesIn(const json& values) {
  const json& list = values["material.objects"];
  Entries entries;
  if (list.is_array())
    for (const json& entry : list)
      if (entry.is_string()) entries.push_back(entry.get<std::string>());
  if (!list.is_array() || entries.size() != list.size())
    throw std::runtime_error("it does not say what material.objects is");
  return entries;
}

std::vector<uint32_t> objectsWithEntries(const Entries& entries) {
  std::vector<uint32_t> objects;
  for (const std::string& entry : entries) objects.push_back(objectOf(entry));
  return objects;
}

std::string joinedWords(const Entries& words) {
  std::string text;
  for (const std::string& word : words) text.append(text.empty() ? "" : " ").append(word);
  return text;
}

int printEntries(const CommandLine& line, const RunningProgram& program, const Entries& entries,
                 const ObjectChoice& choice) {
  std::vector<uint32_t> objects = objectsWithEntries(entries);
  std::sort(objects.begin(), objects.end());
  uint32_t missing = 0;
  json found = json::object();
  const ObjectEntries known(entries);
  for (const uint32_t object : choice.empty() ? objects : chosenObjects(choice, objects, missing))
    found[std::to_string(object)] = joinedWords(known.words(object));
  if (line.json) {
    json all = named(program);
    all["materials"] = found;
    std::cout << jsonText(all) << "\n";
    return 0;
  }
  // Not in the order of `found`, which is that of texts.
  objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
  for (const uint32_t object : objects)
    if (found.contains(std::to_string(object)))
      std::cout << object << " " << printable(found[std::to_string(object)].get<std::string>()) << "\n";
  if (found.empty())
    std::cout << labelOf(program) << ": no " << (choice.empty() ? "" : "such ") << "object has an entry\n";
  return 0;
}

/// The numbers of the objects that change. Throws where there are none.
std::vector<uint32_t> changedObjects(HubSession& hub, const RunningProgram& program,
                                     const MaterialChange& change, const Entries& entries) {
  std::vector<uint32_t> there = objectsWithEntries(entries);
  uint32_t missing = 0;
  if (change.reset) return chosenObjects(change.objects, there, missing);
  there.clear();
  for (const json& object : objectsOf(hub, program))
    there.push_back(static_cast<uint32_t>(objectNumber(object)));
  const std::vector<uint32_t> chosen = chosenObjects(change.objects, there, missing);
  if (missing > 0)
    throw std::runtime_error("it draws no object " + std::to_string(missing) + "; gluray objects shows them");
  if (chosen.empty()) throw std::runtime_error("it draws no such objects; gluray objects shows them");
  return chosen;
}

/// The entries with what the words say of the first `count` objects.
Entries changed(const Entries& entries, const std::vector<uint32_t>& objects, size_t count,
                const Entries& words) {
  ObjectEntries all(entries);
  for (size_t i = 0; i < count; ++i) all.change(objects[i], words);
  return all.all();
}

bool fits(const Entries& entries) {
  return control::textOf(*findSetting("material.objects"), entries).text.size() <= kMaxValueBytes;
}

/// Throws if the entries are more than programs take.
Entries changed(const Entries& entries, const std::vector<uint32_t>& objects, const Entries& words) {
  Entries all = changed(entries, objects, objects.size(), words);
  if (fits(all)) return all;
  size_t most = 0, tooMany = std::min(objects.size(), kMaxValueBytes);  // an entry has more than a byte
  while (most + 1 < tooMany) {
    const size_t middle = (most + tooMany) / 2;
    (fits(changed(entries, objects, middle, words)) ? most : tooMany) = middle;
  }
  throw std::runtime_error("material.objects takes 16 KiB: " + std::to_string(most) + " of these " +
                           std::to_string(objects.size()) + " objects fit");
}

/// Rules of material.file hide objects, too: these are overruled.
std::string wordToShow(const json& values) {
  return values["material.file"] == "" ? "hidden-from=" : "hidden-from=none";
}

/// Whether somebody who names the material does not see it.
bool staysUnseen(const Entries& words, const json& values) {
  const bool named = std::any_of(words.begin(), words.end(), [](const std::string& word) {
    return word.find('=') == word.npos && word != "program";
  });
  return named && (values["integrator"] == "local" || values["integrator"] == "ao");
}

}  // namespace

int changeMaterials(const CommandLine& line) {
  MaterialChange change;
  if (const std::string why = readMaterialChange(line.control, change); !why.empty())
    return say(why), kUsageError;
  HubSession hub(line);
  const RunningProgram program = oneProgram(hub);
  json values;
  Entries entries;
  const Entries before = labelled(program, [&] {
    values = valuesIn(hub, program, {"material.objects", "material.file", "integrator"});
    return entries = entriesIn(values);
  });
  if (!change.changes()) return printEntries(line, program, entries, change.objects);

  if (change.show) change.words.push_back(wordToShow(values));
  labelled(program,
           [&] { entries = changed(entries, changedObjects(hub, program, change, entries), change.words); });
  if (entries == before && !line.json) {
    std::cout << labelOf(program) << ": nothing changes\n";
    return 0;
  }
  const int code =
      sendChange(line, hub, {program}, {{"type", "set"}, {"values", {{"material.objects", entries}}}});
  if (code == 0 && !line.json && staysUnseen(change.words, values))
    say("materials are seen with integrator = path or whitted; it is " +
        values["integrator"].get<std::string>());
  return code;
}

}  // namespace gluray::launcher
