// Materials of single objects, by rules in a file:
//   [[rule]]
//   objects = [1, 3]              # numbers in the order of drawing, from 0; absent: all
//   color = "#ff0000"             # the object's own colour, to one in 255; absent: any
//   triangles = [100, 5000]       # least and most; absent: any
//   material = "glass"            # and roughness, ior, metal, metallic, specular, transmission, coat,
//   emission, absorption
//   hidden-from = ["camera"]      # kinds of rays that do not hit the object; also: shadow, occlusion,
//   reflection
// A rule applies to objects that satisfy all its conditions; later rules win. Read once, kept while the file
// stays the same. Entries of the setting material.objects (settings/object_rule.h) win over all of these. Any
// thread.
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
  bool looks = false;                 // the rule sets a material
  MaterialModel model;                // parameters that the rule does not set come from the settings

  bool holdsFor(const scene::Instance&, const scene::Shading&) const;
};

/// Throws std::runtime_error with the number of the faulty line.
std::vector<MaterialRule> readMaterialRules(const std::string& toml, const MaterialModel& otherwise,
                                            float diagonal);

/// The rays that each instance is hidden from, by the rules of settings.material.file and the entries of
/// settings.material.objects. Empty if nothing is hidden.
accel::HiddenFrom hiddenByRules(const scene::Snapshot&);

/// The colour that an object's state gives it, before vertices and textures; displayed values.
glm::vec3 ownColor(const scene::Shading&, const scene::Instance&);

/// Returns one model for each instance of the snapshot and its secondary scene. Settings apply to lit
/// surfaces, rules and entries to all surfaces. `diagonal`: of the scene's bounds, eye space. If the file
/// cannot be read, logs one line and keeps the last valid rules.
std::vector<MaterialModel> materialsOf(const scene::Snapshot&, float diagonal);

}  // namespace gluray::render
