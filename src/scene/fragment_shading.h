// Shading of fragment programs (src/gl/programs): lighting per pixel with interpolated normals, in place of
// OpenGL's fixed-function equation. Intermediate colours are not clamped.
#pragma once
#include "scene/texture.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace gluray::scene {

/// A light of a fragment program, in the program's eye space.
struct FragmentLight {
  /// headlight: at the viewer; its highlight depends only on the diffuse cosine.
  enum Kind : uint8_t { headlight, directional, positional };
  Kind kind = headlight;
  glm::vec3 color{1};
  glm::vec3 direction{0, 0, -1};  // from the light to the surface, from the program (unit length)
  glm::vec3 position{0};
  glm::vec3 attenuation{1, 0, 0};  // constant, linear, quadratic
  float coneAngle = 180;           // degrees from the axis; >= 90: no cone
  float exponent = 0;              // of the cosine within the cone
  bool operator==(const FragmentLight&) const = default;
};

/// Microfacet reflection of VTK's physically based shading.
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
  Color color = Color::material;  // source of the factor of the material's ambient and diffuse colours
  bool colorIsDiffuseOnly = false;
  bool flipBackFaces = false;  // back faces use the reversed normal
  bool parallelView = false;   // triangle normals face +z instead of the viewer's position
  bool backMaterial = false;   // back faces use MaterialPair::back
  bool texturesOnBack = true;  // back faces are textured
  std::vector<FragmentLight> lights;
  std::vector<Texture> map;  // Color::map: one texture, sampled at the coordinates of unit 0; its matrix
                             // applies to s and t only
  PbrSurface pbr;
  bool writesDepth = false;  // gl_FragDepth: one depth for all samples of a pixel
  bool edges = false;        // paint the triangle edges selected by Instance::triangleEdges
  bool edgesGrow = true;     // edges enlarge their triangles (render/visibility/edged_triangle.h)
  float edgeWidth = 1;       // pixels
  float edgeOpacity = 1;     // largest weight of the edge colour
  glm::vec3 edgeColor{0};
  bool operator==(const FragmentShading&) const = default;
};

}  // namespace gluray::scene
