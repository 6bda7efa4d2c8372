// Entries of the setting material.objects by their objects: what many objects have, and change, takes no
// longer than there are entries. gluray material and the panel; any thread.
#pragma once
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace gluray {

class ObjectEntries {
 public:
  explicit ObjectEntries(const std::vector<std::string>& entries);
  /// As wordsOf() (settings/object_rule.h).
  std::vector<std::string> words(uint32_t object) const;
  /// As withObject().
  void change(uint32_t object, const std::vector<std::string>& words);
  /// The entries; those of one object follow one another.
  std::vector<std::string> all() const;

 private:
  std::vector<uint32_t> order_;
  std::unordered_map<uint32_t, std::vector<std::string>> entries_;  // 0: those that name no object
};

}  // namespace gluray
