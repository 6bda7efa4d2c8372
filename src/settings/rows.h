// The table of all settings, generated from spec/settings.toml. Code that handles every setting (files,
// variables, options, lists) iterates over it. Constant data; any thread.
#pragma once
#include "settings/settings.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace gluray {

enum class Type : uint8_t { boolean, integer, real, choice, color, vector, text, path, list, quirks };
/// When a changed value takes effect: the next frame, the next context, the next run.
enum class Applies : uint8_t { frame, context, process };
/// image: the result differs from the real OpenGL's; way: only the way in which the image is made differs.
enum class Changes : uint8_t { image, way };
/// Who needs the setting. basic: for figures and speed; advanced; expert: for special cases.
enum class Level : uint8_t { basic, advanced, expert };

/// One word of a choice; the enumerators have the same order.
struct Word {
  std::string_view word, help;
};

/// Pointer to a setting's value; choices are stored as the index of their word.
using Place = std::variant<bool*, int*, float*, uint8_t*, glm::vec3*, std::string*, std::vector<std::string>*,
                           QuirkSet*>;

struct Row {
  std::string_view name, title;  // "ao.samples", and for people "Occlusion rays"
  Type type;
  Applies applies;
  Changes changes;
  bool ranged, files;              // numbers are limited to [least, most]; texts are file names
  bool explains, exists, inFiles;  // as in spec/settings.toml
  double least, most;
  std::string_view leastMeans, unit, help, more, group;
  Level level;
  std::string_view since;
  std::string_view option, placeholder;  // "--threads" (empty: only --set) and "N" for its value
  std::span<const Word> words = {};
  std::string (*check)(std::string_view entry) = nullptr;  // checks a list's entry; empty: valid
  Place (*place)(Session&);
};

std::span<const Row> settingRows();

/// The groups of settings, in the order of pages and lists. Each row's `group` is one of them.
std::span<const std::string_view> settingGroups();

/// The rows of a group: basic ones, then advanced and expert ones, each in the order of spec/settings.toml.
std::vector<const Row*> rowsOfGroup(std::string_view group);

/// The word of a level in spec/settings.toml: "basic", "advanced" or "expert".
std::string_view nameOf(Level level);

/// The row of a setting; null if no setting has the name.
const Row* findSetting(std::string_view name);

/// The environment variable of a setting: "log-level" -> "GLURAY_LOG_LEVEL".
std::string variableOf(const Row& row);

/// Separator of a list's entries: ':' between files, ',' otherwise.
char separatorOf(const Row& row);

/// Error message for an unknown name: "no setting is called 'bhv'; did you mean 'bvh'?".
std::string unknownSetting(std::string_view name);

}  // namespace gluray
