// Entries of the setting material.objects, indexed by object, so that reading or changing many objects takes
// linear time. Used by gluray material and the panel; any thread.
#pragma once
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace gluray {

class ObjectEntries {
 public:
  explicit ObjectEntries(const std::vector<std::string>& entries);
  /// The words of an object, as wordsOf() (settings/object_rule.h) returns them.
  std::vector<std::string> words(uint32_t object) const;
  /// Changes the entry of an object, as withObject() does.
  void change(uint32_t object, const std::vector<std::string>& words);
  /// All entries; those of one object are consecutive.
  std::vector<std::string> all() const;

 private:
  std::vector<uint32_t> order_;
  std::unordered_map<uint32_t, std::vector<std::string>> entries_;  // 0: entries that name no object
};

}  // namespace gluray
