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
  /// Ignores invalid entries, which the setting does not accept anyway.
  explicit ObjectRules(const Settings&);
  /// Whether an entry hides an object from some rays.
  bool hide() const { return hide_; }
  /// Bits as in accel::HiddenFrom; none if no entry sets them.
  std::optional<uint8_t> hiddenFrom(const scene::Instance&) const;
  std::optional<MaterialModel> modelOf(const scene::Instance&, float diagonal) const;

 private:
  const ObjectRule* ruleOf(const scene::Instance&) const;

  std::unordered_map<uint32_t, ObjectRule> rules_;  // by object
  bool hide_ = false;
};

}  // namespace gluray::render
