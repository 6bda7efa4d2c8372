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

/// One word of a choice; the enumerators have the same order.
struct Word {
  std::string_view word, help;
};

/// Pointer to a setting's value; choices are stored as the index of their word.
using Place = std::variant<bool*, int*, float*, uint8_t*, glm::vec3*, std::string*, std::vector<std::string>*,
                           QuirkSet*>;

struct Row {
  std::string_view name;
  Type type;
  Applies applies;
  Changes changes;
  bool ranged, files;              // numbers are limited to [least, most]; texts are file names
  bool explains, exists, inFiles;  // as in spec/settings.toml
  double least, most;
  std::string_view leastMeans, unit, help, more, group, since;
  std::string_view option, placeholder;  // "--threads" (empty: only --set) and "N" for its value
  std::span<const Word> words = {};
  std::string (*check)(std::string_view entry) = nullptr;  // checks a list's entry; empty: valid
  Place (*place)(Session&);
};

std::span<const Row> settingRows();

/// The row of a setting; null if no setting has the name.
const Row* findSetting(std::string_view name);

/// The environment variable of a setting: "log-level" -> "GLURAY_LOG_LEVEL".
std::string variableOf(const Row& row);

/// Separator of a list's entries: ':' between files, ',' otherwise.
char separatorOf(const Row& row);

/// Error message for an unknown name: "no setting is called 'bhv'; did you mean 'bvh'?".
std::string unknownSetting(std::string_view name);

}  // namespace gluray
