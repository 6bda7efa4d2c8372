// Shading by fragment shaders (src/gl/programs): lighting per pixel with interpolated normals, in place of
// OpenGL's fixed-function equation. Intermediate colours are not clamped.
#pragma once
#include "scene/texture.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace gluray::scene {

/// A light of a fragment shader, in the eye space of its program.
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
  bool ownHighlight = false;       // `highlight`, without the material's specular colour, and `shininess`
  glm::vec3 highlight{1};
  float shininess = 0;
  glm::vec3 half{0};  // Specular::ofLight
  bool operator==(const FragmentLight&) const = default;
};

/// Light that arrives from an environment image, prefiltered by the program.
struct PbrEnvironment {
  glm::mat3 worldFromEye{1};                        // from the program's eye space to the space of the images
  bool byHarmonics = false;                         // irradiance is given by `harmonics` instead of an image
  std::array<std::array<float, 9>, 3> harmonics{};  // of red, green, blue: coefficients for each function
  std::vector<Texture> irradiance;                  // one cube map; none if byHarmonics
  std::vector<Texture> prefiltered;                 // one cube map; rougher surfaces use smaller levels
  std::vector<Texture> brdf;                        // one texture by cosine and roughness: factors of f0, f90
  float maxLevel = 0;                               // level of `prefiltered` for roughness 1
  float intensity = 1;                              // factor of all this light
  /// Not below 0: light that is scattered several times in the surface counts (Fdez-Aguera, "A
  /// Multiple-Scattering Microfacet Model for Real-Time Image-based Lighting", 2019); diffuse light is
  /// reduced by this reflectance.
  float diffuseF0 = -1;
  bool on() const { return !prefiltered.empty(); }
  bool operator==(const PbrEnvironment&) const = default;
};

/// Microfacet reflection of physically based shading.
struct PbrSurface {
  /// Masking and shadowing. correlated: Smith's function, correlated in height, as VTK has it. separate:
  /// Schlick's approximation of Smith's function, a factor each for light and viewer (Karis, "Real Shading in
  /// Unreal Engine 4", 2013); normals that face away count as facing, and `ambient` light is reflected.
  enum class Masking : uint8_t { correlated, separate };
  /// Texture unit of the coordinates that are the vertices' tangents.
  static constexpr uint32_t kTangentUnit = 2;

  Masking masking = Masking::correlated;
  float metallic = 0, roughness = 0.5f, baseF0 = 0.04f;
  glm::vec3 edgeTint{1}, emissive{0};
  glm::vec3 ambient{0};         // Masking::separate: factor of the base colour
  float occlusionStrength = 1;  // weight of the occlusion in `material`
  float normalScale = 1;        // of x and y in `normal`
  float distributionFloor = 0;  // least divisor of the distribution of normals, pi times a square
  std::vector<Texture> textures;
  // Indices into `textures`; -1: none. material: occlusion in red, roughness in green, metallic in blue, each
  // a factor. emission: a factor. normal: normals in tangent space, 0 .. 1 for components -1 .. 1.
  int material = -1, emission = -1, normal = -1;
  PbrEnvironment environment;
  bool operator==(const PbrSurface&) const = default;
};

/// Colours by a coordinate of the point in object space: each channel is the power `exponent` of scale times
/// (coordinate + offset), clamped to [0, 1]. Where an exponent is not 1, the base must not be negative.
struct HeightColors {
  int axis = 2;
  glm::vec3 scale{1}, offset{0}, exponent{1};
  bool operator==(const HeightColors&) const = default;
};

/// Changes towards silhouettes, with the weight x^2 + y^2 of the normal to a power above 0.
struct Rim {
  bool on = false;
  bool mixes = true;  // colours are mixed with `color`
  glm::vec3 color{1};
  float exponent = 1;
  float opacity = 0;  // alpha is multiplied by 1 + opacity times the weight; it is at most 1
  bool operator==(const Rim&) const = default;
};

struct FragmentShading {
  enum class Model : uint8_t { off, unlit, phong, pbr };  // off: OpenGL's fixed function
  /// The cosine of highlights: of the reflected ray and the viewer, or of the normal and a vector: halfway
  /// between light and viewer, or that of the light.
  enum class Specular : uint8_t { reflect, half, ofLight };
  /// By what the material's specular colour is multiplied: nothing, the base colour, or 1 minus the base
  /// colour.
  enum class HighlightColor : uint8_t { material, base, complement };
  enum class Normals : uint8_t { vertices, triangles, perTriangle };
  enum class Color : uint8_t { material, vertices, map, perTriangle, height };
  /// Where vertex normals are normalised: after interpolation, before it (in the program's eye space), both,
  /// or, where they are colours alone, nowhere.
  enum class UnitNormals : uint8_t { pixels, vertices, both, never };

  Model model = Model::off;
  Specular specular = Specular::reflect;
  HighlightColor highlightColor = HighlightColor::material;
  Normals normals = Normals::vertices;
  Color color = Color::material;  // source of the factor of the material's ambient and diffuse colours
  bool colorIsDiffuseOnly = false;
  HeightColors height;      // Color::height
  float colorExponent = 1;  // of red, green and blue from this source, before textures
  float encoding = 1;       // unlit: the result, before textures after light, is raised to 1 divided by this
  UnitNormals unitNormals = UnitNormals::pixels;
  bool facesViewer = false;       // vertex normals are turned to the viewer before they are interpolated
  bool normalColors = false;      // red, green and blue of `color` are half the vertex normal plus a half
  Rim rim;                        // of colours, by the vertex normal
  bool clampsColors = false;      // vertex colours are clamped to [0, 1] before they are interpolated
  bool ignoresAlpha = false;      // the alpha of vertex colours is taken to be 1
  bool twoSidedLights = false;    // Phong: the diffuse cosine's absolute value counts
  bool highlightsInDark = false;  // Phong: also where the diffuse cosine is not positive
  bool infiniteViewer = false;    // Phong: highlights as if the viewer were at infinity, along +z
  bool clampsLight = false;       // Phong: ambient plus diffuse light, the factor of `color`, is at most 1
  bool darkBackFaces = false;     // Phong: lights do not shine on back faces
  bool flipBackFaces = false;     // back faces use the reversed vertex normal
  bool flipsTriangles = false;    // and the reversed triangle normal
  bool parallelView = false;      // triangle normals face +z instead of the viewer's position
  bool backMaterial = false;      // back faces use MaterialPair::back
  bool paintsBack = false;        // back faces show `backColor`, without lights, textures and fog
  glm::vec3 backColor{0};
  bool texturesOnBack = true;      // back faces are textured
  bool texturesFirst = false;      // textures multiply `color` before it is lit, not the lit colour
  bool texturesKeepAlpha = false;  // with texturesFirst: their alpha does not count
  std::vector<FragmentLight> lights;
  std::vector<Texture> map;  // Color::map: one texture, sampled at the coordinates of unit 0; its matrix
                             // applies to s and t only
  /// Unlit: none, or four images that the vertex normal looks up at (x, -y) * 0.49 + 0.5. The colour becomes
  /// the sum of red, green and blue times the first three, plus the rest, 1 minus their sum, times the last.
  std::vector<Texture> matcap;
  float backFactor = 1;  // unlit: of red, green and blue of back faces
  PbrSurface pbr;
  bool writesDepth = false;  // gl_FragDepth: one depth for all samples of a pixel
  bool edges = false;        // paint the triangle edges selected by Instance::triangleEdges
  bool edgesAlone = false;   // alpha is multiplied by the weight of the edges; their colour is the surface's
  bool edgesGrow = true;     // edges enlarge their triangles (render/edges/edged_triangle.h)
  float edgeWidth = 1;       // pixels
  float edgeOpacity = 1;     // largest weight of the edge colour
  glm::vec3 edgeColor{0};
  bool operator==(const FragmentShading&) const = default;
};

}  // namespace gluray::scene
