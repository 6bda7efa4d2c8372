#include "render/bsdf/object_rules.h"

#include "accel/rays/ray_kind.h"

namespace gluray::render {

static_assert(bitOf(accel::RayKind::camera) == 1 && bitOf(accel::RayKind::shadow) == 2 &&
              bitOf(accel::RayKind::occlusion) == 4 && bitOf(accel::RayKind::reflection) == 8);

ObjectRules::ObjectRules(const Settings& settings) {
  Settings::Material otherwise = settings.material;
  otherwise.objects.clear(), otherwise.file.clear();
  for (const std::string& entry : settings.material.objects) {
    const auto earlier = rules_.find(objectOf(entry));
    const bool more = earlier != rules_.end() && earlier->second.looks;  // it adds to that
    ObjectRule rule;
    if (!readObjectRule(entry, more ? earlier->second.material : otherwise, rule).empty()) continue;
    ObjectRule& kept = rules_.try_emplace(rule.object, rule).first->second;
    if (rule.looks) kept.looks = true, kept.material = rule.material;
    if (rule.hiddenFrom) kept.hiddenFrom = rule.hiddenFrom;
  }
  for (const auto& [unused, rule] : rules_) hide_ |= rule.hiddenFrom.value_or(0) != 0;
}

const ObjectRule* ObjectRules::ruleOf(const scene::Instance& instance) const {
  if (instance.ground || rules_.empty()) return nullptr;
  const auto found = rules_.find(instance.object.value);
  return found == rules_.end() ? nullptr : &found->second;
}

std::optional<uint8_t> ObjectRules::hiddenFrom(const scene::Instance& instance) const {
  const ObjectRule* const rule = ruleOf(instance);
  return rule ? rule->hiddenFrom : std::nullopt;
}

std::optional<MaterialModel> ObjectRules::modelOf(const scene::Instance& instance, float diagonal) const {
  const ObjectRule* const rule = ruleOf(instance);
  if (!rule || !rule->looks) return std::nullopt;
  Settings settings;
  settings.material = rule->material;
  return MaterialModel::fromSettings(settings, diagonal);
}

}  // namespace gluray::render
