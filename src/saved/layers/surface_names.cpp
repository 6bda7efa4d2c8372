#include "saved/layers/surface_names.h"

#include "render/bsdf/material_rules.h"
#include "settings/rows.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace gluray::saved {
namespace {

std::string objectName(const scene::Instance& instance) {
  return instance.object.value ? "object " + std::to_string(instance.object.value) : "other";
}

/// What gives a surface its colour.
std::string colorName(const scene::Shading& shading, const scene::Instance& instance) {
  if (instance.triangleColors) return " by triangle";
  if (instance.mesh->colors) return " by vertex";
  const glm::vec3 color = render::ownColor(shading, instance);
  char text[16];
  const auto byte = [&](int c) {
    return static_cast<unsigned>(std::lround(255 * std::clamp(color[c], 0.0f, 1.0f)));
  };
  std::snprintf(text, sizeof text, " #%02x%02x%02x", byte(0), byte(1), byte(2));
  return text;
}

std::string kindName(const render::MaterialModel& model) {
  const Row* const row = findSetting("material");
  const auto kind = static_cast<size_t>(model.kind);
  return row && kind < row->words.size() ? std::string(row->words[kind].word) : "program";
}

}  // namespace

SurfaceNames surfaceNames(const std::vector<Shot::Placed>& batches) {
  SurfaceNames names;
  for (const Shot::Placed& batch : batches) {
    const scene::Snapshot& s = batch.snapshot;
    names.first.push_back(names.objects.size());
    const std::vector<render::MaterialModel> models = render::materialsOf(s, 1);
    for (size_t i = 0; i < s.instances.size(); ++i) {
      const scene::Instance& instance = s.instances[i];
      names.objects.push_back(objectName(instance));
      names.materials.push_back(kindName(models[i]) + colorName(s.shadings[instance.shading], instance));
      names.numbered = names.numbered || instance.object.value;
    }
    names.objects.emplace_back("ground"), names.materials.emplace_back("ground");
  }
  return names;
}

}  // namespace gluray::saved
