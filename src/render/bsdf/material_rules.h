// Materials of single objects, by rules in a file:
//   [[rule]]
//   objects = [1, 3]              # numbers in the order of drawing, from 0; absent: all
//   color = "#ff0000"             # the object's own colour, to one in 255; absent: any
//   triangles = [100, 5000]       # least and most; absent: any
//   material = "glass"            # and roughness, ior, metal, metallic, specular, transmission, coat,
//   emission, absorption
//   hidden-from = ["camera"]      # kinds of rays that it does not exist for: and shadow, occlusion,
//   reflection
// A rule holds for objects that meet all its conditions; later rules win. Read once, kept while the file
// stays the same. Entries of the setting material.objects (settings/object_rule.h) win over all of these.
// Any thread.
#pragma once
#include "accel/rays/ray_kind.h"
#include "render/bsdf/material_model.h"
#include "scene/snapshot.h"

#include <optional>
#include <string>
#include <vector>

namespace gluray::render {

struct MaterialRule {
  std::vector<uint32_t> objects;  // empty: all
  std::optional<glm::vec3> color;
  std::optional<glm::uvec2> triangles;
  std::optional<uint8_t> hiddenFrom;  // bits as in accel::HiddenFrom; absent: as earlier rules say
  bool looks = false;                 // the rule says what the object is made of
  MaterialModel model;                // what the rule does not say is as the settings have it

  bool holdsFor(const scene::Instance&, const scene::Shading&) const;
};

/// Throws std::runtime_error with the line of what is wrong.
std::vector<MaterialRule> readMaterialRules(const std::string& toml, const MaterialModel& otherwise,
                                            float diagonal);

/// What the rules of settings.material.file and the entries of settings.material.objects hide. Empty where
/// they hide nothing.
accel::HiddenFrom hiddenByRules(const scene::Snapshot&);

/// One for each instance of the snapshot and its surroundings: by settings where the surface is lit, by rules
/// and entries for any. `diagonal`: of the scene's bounds, eye space. A file that cannot be read is reported
/// in one line; the last one that could stays.
std::vector<MaterialModel> materialsOf(const scene::Snapshot&, float diagonal);

}  // namespace gluray::render
