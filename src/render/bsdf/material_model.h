// Which model a surface has, and its parameters; its colours come from the program at each hit. Made once a
// frame from settings and rules, read by every tracing thread.
#pragma once
#include "render/bsdf/any.h"
#include "scene/fragment_shading.h"
#include "settings/settings.h"

namespace gluray::render {

struct MaterialModel {
  SurfaceMaterial kind = SurfaceMaterial::program;
  float roughness = 0.2f, ior = 1.5f;
  SurfaceMetal metal = SurfaceMetal::aluminium;
  float metallic = 0, specular = 0.5f, transmission = 0, coat = 0;  // of `principled`
  float emission = 1;  // of `emissive`: radiance, in multiples of the program's colour
  float absorption =
      0;  // eye space: distance inside glass over which light takes on the colour once; 0: at surfaces

  /// The model of the settings, for lit surfaces. `diagonal`: of the scene's bounds, eye space.
  static MaterialModel fromSettings(const Settings&, float diagonal);

  bool isProgram() const { return kind == SurfaceMaterial::program; }
  bool isEmissive() const { return kind == SurfaceMaterial::emissive; }
  /// Whether light is transmitted into the surface.
  bool isBody() const {
    return kind == SurfaceMaterial::glass || (kind == SurfaceMaterial::principled && transmission > 0);
  }
  bool isTransparent() const { return isBody() || kind == SurfaceMaterial::thinGlass; }
  /// The BSDF at a hit. `inside`: the path arrives from inside the body.
  bsdf::Any bsdf(const glm::vec3& color, bool inside) const;
};

/// The model of VTK's physically based surfaces.
bsdf::VtkPbr vtkBsdf(const scene::PbrSurface&, const glm::vec3& color, float metallic, float roughness);

}  // namespace gluray::render
