// The table of all settings, generated from spec/settings.toml. Whatever treats settings alike (files,
// variables, options, lists) goes through it. Constant data; any thread.
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
/// From when on another value counts: the next frame, the next context, the next run.
enum class Applies : uint8_t { frame, context, process };
/// Whether the real OpenGL would show another picture, or only the way to the picture differs.
enum class Changes : uint8_t { picture, way };

/// One word of a choice; the enumerators have the same order.
struct Word {
  std::string_view word, help;
};

/// Where the value of a setting is; choices as the number of their word.
using Place = std::variant<bool*, int*, float*, uint8_t*, glm::vec3*, std::string*, std::vector<std::string>*,
                           QuirkSet*>;

struct Row {
  std::string_view name;
  Type type;
  Applies applies;
  Changes changes;
  bool ranged, files;              // numbers lie between `least` and `most`; texts name files
  bool explains, exists, inFiles;  // the fields of spec/settings.toml
  double least, most;
  std::string_view leastMeans, unit, help, more, group, since;
  std::string_view option, placeholder;  // "--threads" (empty: none of its own) and its value's "N"
  std::span<const Word> words = {};
  Place (*place)(Session&);
};

std::span<const Row> settingRows();

/// Null where no setting has the name.
const Row* findSetting(std::string_view name);

/// "log-level" -> "GLURAY_LOG_LEVEL".
std::string variableOf(const Row& row);

/// What stands between the entries of a list in one text: ':' between files, ',' otherwise.
char separatorOf(const Row& row);

/// What a user may do about a name that no setting has: "no setting is called 'bhv'; did you mean 'bvh'?".
std::string unknownSetting(std::string_view name);

}  // namespace gluray
