// The entries of the setting material.objects, for the instances of a snapshot. Made once a frame; any
// thread.
#pragma once
#include "render/bsdf/material_model.h"
#include "scene/snapshot.h"
#include "settings/object_rule.h"

#include <cstdint>
#include <optional>
#include <unordered_map>

namespace gluray::render {

class ObjectRules {
 public:
  /// Entries that cannot be read say nothing: the setting does not take them.
  explicit ObjectRules(const Settings&);
  /// Whether one of them hides an object.
  bool hide() const { return hide_; }
  /// Bits as in accel::HiddenFrom; none where the entries do not say.
  std::optional<uint8_t> hiddenFrom(const scene::Instance&) const;
  std::optional<MaterialModel> modelOf(const scene::Instance&, float diagonal) const;

 private:
  const ObjectRule* ruleOf(const scene::Instance&) const;

  std::unordered_map<uint32_t, ObjectRule> rules_;  // by object
  bool hide_ = false;
};

}  // namespace gluray::render
