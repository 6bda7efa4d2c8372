// Settings that the user chose by options of the launcher.
#pragma once
#include "settings/rows.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gluray::launcher {

/// Name and value, in the order in which they were first chosen.
using NamedValues = std::vector<std::pair<std::string, std::string>>;

class ChosenSettings {
 public:
  /// Appends `value` to a list or to quirks; replaces any other setting's value.
  void add(std::string_view name, const std::string& value);
  void set(std::string_view name, const std::string& value);
  void remove(std::string_view name);
  /// The value; empty if not chosen.
  std::string find(std::string_view name) const;
  const NamedValues& all() const { return values_; }

 private:
  NamedValues values_;
};

/// The value of a setting that names files, with absolute file names: programs may have another directory.
std::string absoluteFiles(const Row& row, const std::string& value);

/// The values to pass to the program: with absolute file names, since it may change its directory, and with
/// the environment's entries added to lists and quirks.
NamedValues passedValues(const ChosenSettings& chosen);

}  // namespace gluray::launcher
