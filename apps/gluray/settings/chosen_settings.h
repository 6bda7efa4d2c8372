// Settings that the user chose by options of the launcher.
#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gluray::launcher {

/// Name and value, in the order in which they were first chosen.
using NamedValues = std::vector<std::pair<std::string, std::string>>;

class ChosenSettings {
 public:
  /// One more value: lists and quirks grow by it, all else is replaced.
  void add(std::string_view name, const std::string& value);
  void set(std::string_view name, const std::string& value);
  void remove(std::string_view name);
  /// Empty where it was not chosen.
  std::string find(std::string_view name) const;
  const NamedValues& all() const { return values_; }

 private:
  NamedValues values_;
};

/// The values as the program gets them: with absolute names of files, as it may change its directory, and
/// with what the environment adds to lists and quirks.
NamedValues passedValues(const ChosenSettings& chosen);

}  // namespace gluray::launcher
