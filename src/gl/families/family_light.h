// Parts of families of shader programs (family.h): values, materials, lights and fog.
#pragma once
#include "scene/fragment_shading.h"
#include "scene/shading.h"

#include <string>
#include <vector>

namespace gluray::gl {

/// A number, vector or matrix: the value of a uniform, a constant, or, if the name is that of a placeholder,
/// a number in the program's statements. If both are empty, the family does not specify it. `factors`:
/// further uniforms that it is multiplied by.
struct FamilyValue {
  std::string uniform;
  std::vector<float> constant;
  std::vector<std::string> factors = {};
  bool given() const { return !uniform.empty() || !constant.empty(); }
};

/// Reflectance of one face. Defaults: 0 for the ambient and specular intensities, 1 for everything else.
struct FamilyMaterial {
  FamilyValue ambientIntensity, ambientColor, diffuseIntensity, diffuseColor, specularIntensity,
      specularColor;
  FamilyValue emission;  // added to ambient light; only in families without vertex colours
  FamilyValue shininess, opacity;
  std::string unusedOpacityInSource;  // text in the source of programs that do not use `opacity`
  bool given() const { return diffuseColor.given() || diffuseIntensity.given(); }
};

/// Lights are numbered from 0; {} in a name stands for the number or, if `names` is not empty, for that name.
/// Light n is on if its `color` is an active uniform. If the family names no colour, the light is white, and
/// it is on if its direction or position is active.
struct FamilyLights {
  /// Where lights without direction and position are: at infinity behind the viewer, or at the viewer.
  enum class Headlight { infinite, viewer };
  std::vector<std::string> names;
  std::string count;                // number of lights that are on; empty: all
  std::string countInSource;        // text that occurs in the source once for each light; empty: none
  std::string noHighlightInSource;  // text that occurs once for each light without highlight, the last ones
  std::string enabled;              // 0: the base colour is shown without lights
  bool unlitIsMaterial = false;     // without lights: ambient plus diffuse colour, as Model::unlit
  std::string color;
  FamilyValue direction;                      // eye space, from the light to the surface
  bool towardsLight = false;                  // `direction` points from the surface to the light
  std::string position;                       // eye space
  std::vector<std::string> positionMatrix;    // uniforms, from left to right: to eye space, where it is not
  std::string positional;                     // not 0: the light has a position; 0: only a direction
  FamilyValue intensity, highlightIntensity;  // factors of `color`; the second makes own highlights
  std::string attenuation, coneAngle, exponent;
  Headlight headlight = Headlight::infinite;
  bool twoSided = false;          // lights shine on both sides of surfaces
  bool highlightsInDark = false;  // highlights also appear if the diffuse cosine is negative
  /// Colours and exponents of the lights' highlights. They replace the product of light colour and specular
  /// material colour, and the material's exponent. The last entry also applies to all further lights.
  std::vector<FamilyValue> specularColor, shininess;
  bool infiniteViewer = false;           // highlights as if the viewer were at infinity
  bool viewerAtVertices = false;         // directions to the viewer are those of the vertices, interpolated
  bool highlightsNeedShininess = false;  // there are none where the exponent is not above 0
  FamilyValue halfVector;                // highlights depend on the cosine between the normal and this vector
  using HighlightColor = scene::FragmentShading::HighlightColor;
  HighlightColor highlightColor = HighlightColor::material;
  bool clamped = false;  // ambient plus diffuse light is at most 1
};

/// The name of the variable of light `number`; `pattern` has {} for the light.
std::string ofLight(const std::string& pattern, const FamilyLights& lights, int number);

struct FamilyPbr {
  scene::PbrSurface::Masking masking = scene::PbrSurface::Masking::correlated;
  FamilyValue ambient;  // scene::PbrSurface::ambient
  FamilyValue metallic, roughness, baseF0, edgeTint, emissive;
  FamilyValue occlusionStrength;            // of the material texture's occlusion
  std::string materialTexture;              // sampler: occlusion, roughness and metallic in red, green, blue
  std::string emissiveTexture;              // sampler: factor of `emissive`
  std::string normalTexture;                // sampler: normals in tangent space
  FamilyValue normalScale;                  // of x and y of these normals
  std::string environmentMatrix;            // uniform: from eye space to the environment's images
  std::string irradiance;                   // cube sampler
  std::vector<std::string> harmonics;       // uniforms in place of `irradiance`, one per colour: 9 numbers
  std::string prefiltered;                  // cube sampler; its levels are for increasing roughness
  std::string prefilteredMaxLevelInSource;  // text before the level for roughness 1 in the source
  std::string brdfTable;                    // sampler, looked up at cosine and roughness
  FamilyValue environmentIntensity;         // factor of the environment's light
  FamilyValue multipleScattering;           // scene::PbrEnvironment::diffuseF0; not given: single scattering
  FamilyValue distributionFloor;            // scene::PbrSurface::distributionFloor
  bool given() const { return roughness.given(); }
};

/// Fog by the distance -z in eye space. Without `color` there is no fog.
struct FamilyFog {
  scene::Fog::Mode mode = scene::Fog::linear;
  std::string modeFrom;   // uniform that selects the mode: 1 linear, 2 exp, 3 exp2, otherwise none
  bool absolute = false;  // distance is the absolute value of z at the vertices, interpolated
  FamilyValue color, start, end, scale, density;
  bool extrapolated = false;  // linear: the weight of the surface's colour may become negative
  bool given() const { return color.given(); }
};

}  // namespace gluray::gl
