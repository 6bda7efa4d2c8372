// Shading as fragment programs do it (src/gl/programs): lighting at every pixel with a normal interpolated
// between the corners, in place of OpenGL's fixed-function equation. Colours are not clamped on the way.
#pragma once
#include "scene/texture.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace gluray::scene {

/// A light of a fragment program, in the program's eye space.
struct FragmentLight {
  /// headlight: at the viewer, its highlight depends on the diffuse cosine alone.
  enum Kind : uint8_t { headlight, directional, positional };
  Kind kind = headlight;
  glm::vec3 color{1};
  glm::vec3 direction{0, 0, -1};  // from the light to the surface, as the program has it (unit length)
  glm::vec3 position{0};
  glm::vec3 attenuation{1, 0, 0};  // constant, linear, quadratic
  float coneAngle = 180;           // degrees from the axis; from 90 on: no cone
  float exponent = 0;              // of the cosine within the cone
  bool operator==(const FragmentLight&) const = default;
};

/// Microfacet reflection as VTK's physically based shading has it.
struct PbrSurface {
  float metallic = 0, roughness = 0.5f, baseF0 = 0.04f;
  glm::vec3 edgeTint{1}, emissive{0};
  bool operator==(const PbrSurface&) const = default;
};

struct FragmentShading {
  enum class Model : uint8_t { off, unlit, phong, pbr };  // off: OpenGL's fixed function
  enum class Specular : uint8_t { reflect, half };
  enum class Normals : uint8_t { vertices, triangles, perTriangle };
  enum class Color : uint8_t { material, vertices, map, perTriangle };

  Model model = Model::off;
  Specular specular = Specular::reflect;
  Normals normals = Normals::vertices;
  Color color = Color::material;  // what the material's ambient and diffuse colours are multiplied by
  bool colorIsDiffuseOnly = false;
  bool flipBackFaces = false;  // back faces have the reversed normal
  bool parallelView = false;   // triangle normals face +z instead of the viewer's place
  bool backMaterial = false;   // back faces have MaterialPair::back
  bool texturesOnBack = true;  // back faces have textures
  std::vector<FragmentLight> lights;
  std::vector<Texture> map;  // Color::map: one texture, looked up at the coordinates of unit 0; its matrix is
                             // applied to s and t alone
  PbrSurface pbr;
  bool writesDepth = false;  // gl_FragDepth: one depth for all samples of a pixel
  bool edges = false;        // triangle edges are painted, those that Instance::triangleEdges has a bit for
  bool edgesGrow = true;     // and triangles grow with them (render/visibility/edged_triangle.h)
  float edgeWidth = 1;       // pixels
  float edgeOpacity = 1;     // the largest share of the edges' colour
  glm::vec3 edgeColor{0};
  bool operator==(const FragmentShading&) const = default;
};

}  // namespace gluray::scene
