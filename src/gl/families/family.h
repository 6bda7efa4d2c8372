// Program families: descriptions, as data, of shader programs whose pictures we know how to trace. A family
// says by which names of active variables a program is recognised, and which of them carry geometry,
// matrices, material and lights. Files: spec/programs/*.toml (built in) and what --program-families adds;
// format: docs/program-families.md.
#pragma once
#include "gl/families/known_code.h"
#include "scene/impostors.h"
#include "scene/mesh.h"

#include <array>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace gluray::gl {

/// A number, vector or matrix: the value of a uniform, or a constant. Empty: the family has none.
struct FamilyValue {
  std::string uniform;
  std::vector<float> constant;
  bool given() const { return !uniform.empty() || !constant.empty(); }
};

/// One face's reflectance. What is not given is 0 for intensities of ambient and specular, otherwise 1.
struct FamilyMaterial {
  FamilyValue ambientIntensity, ambientColor, diffuseIntensity, diffuseColor, specularIntensity,
      specularColor;
  FamilyValue shininess, opacity;
  bool given() const { return diffuseColor.given() || diffuseIntensity.given(); }
};

/// Lights are numbered from 0; {} in a name stands for the number. They are on as long as `color` is active,
/// or, where the family names no colour (then it is white), direction or position.
struct FamilyLights {
  /// Where lights with neither direction nor position are: at infinity behind the viewer, or in the viewer's
  /// place.
  enum class Headlight { infinite, viewer };
  std::string count;  // how many of them are on; empty: all
  std::string color;
  std::string direction;  // eye space, from the light to the surface, or towards it
  bool towardsLight = false;
  std::string position;    // eye space
  std::string positional;  // not 0: the light has a position, otherwise a direction alone
  std::string attenuation, coneAngle, exponent;
  Headlight headlight = Headlight::infinite;
};

struct FamilyPbr {
  FamilyValue metallic, roughness, baseF0, edgeTint, emissive;
  bool given() const { return roughness.given(); }
};

/// Round impostors that the program cuts out of the billboards that its geometry shader makes of points.
struct FamilyImpostors {
  scene::Shape shape = scene::Shape::triangles;  // that: none
  FamilyValue radius;                            // `uniform` may be an attribute's name
  std::string axis;                              // attribute, as long as the cylinder
  FamilyValue inside;                            // below 0: the far side of spheres is seen
  FamilyValue radiusDivisor;
  scene::Impostors::Billboards billboards = scene::Impostors::Billboards::silhouette;
  bool fades = false;
  bool grows = false;                              // of tubes
  FamilyValue size, bulge, bulgeDepth, depthBias;  // of beads and tubes: scene::Impostors
  FamilyValue scale;                               // times the radius; splats
  FamilyValue billboardScale;                      // of splats' billboards, in radii
  std::string projection;                          // uniform matrix that splats are projected by
  bool given() const { return shape != scene::Shape::triangles; }
};

/// Names that stand for one variable of a family: those that a program may have instead, the best first.
using Alternatives = std::map<std::string, std::vector<std::string>, std::less<>>;

/// Uniforms without effect while they have one value: numbers, column by column. One number is that of all
/// components; none is the identity matrix.
using NeutralValues = std::map<std::string, std::vector<float>, std::less<>>;

struct Family {
  enum class Model { unlit, phong, pbr };
  /// What the exponent of the highlight is applied to: the reflected ray and the viewer, or normal and half
  /// vector.
  enum class Specular { reflect, half };
  /// Normals of programs that get none with their vertices.
  enum class NoNormals { refuse, triangle };

  std::string name;
  std::string rasteriseBecause;  // not empty: programs of this family are never traced, and why
  std::vector<std::string> sourceHas, sourceLacks;  // texts in the shaders' source
  std::vector<std::string> active, any, absent;     // names for recognition: all of, one of, none of
  std::vector<std::string> absentOutputs;           // of the fragment shader
  std::vector<std::string> ignored;                 // may be active and mean nothing to the picture
  NeutralValues neutral;          // mean nothing to the picture while they have these values
  std::vector<std::string> code;  // sections that have all of its statements; empty: any code
  std::string codeAt;             // file and line that name them
  bool strict = true;  // an active variable that the family does not mention makes the program unknown

  std::string position, normal, color, texcoord;                 // attributes
  std::string instanceTransform, instanceNormal, instanceColor;  // attributes that each instance has one of
  std::vector<std::string> clipFromObject, eyeFromObject;        // uniforms, multiplied from left to right
  std::string viewer;        // uniform: the viewer's place in the space of eyeFromObject; empty: its origin
  std::string normalMatrix;  // uniform; empty: inverse transpose of eyeFromObject
  NoNormals withoutNormals = NoNormals::refuse;
  bool flipBackFaces = false;  // back faces are lit with the reversed normal
  std::string parallelView;    // uniform, not 0: the viewer is at infinity (for triangle normals)

  std::string colorMap;        // sampler; looked up at the texture coordinate, gives the colour
  std::string mapTexcoord;     // attribute where the map is looked up instead; empty: the texture coordinate
  std::string texcoordMatrix;  // uniform, applied to all texture coordinates before they are interpolated
  std::string triangleColors;  // buffer sampler: a colour a triangle
  std::string triangleNormals;
  std::string triangleOffset;         // uniform, added to the triangle's number
  std::string uniformColors;          // uniform, not 0: colours of the material after all
  bool colorIsDiffuseOnly = false;    // otherwise it replaces the ambient colour, too
  std::string texturesOnBack;         // uniform, 0: back faces have no textures
  std::vector<std::string> textures;  // samplers; multiply the lit colour
  std::string anyTexture;             // one of them; a sampler2D of any other name may stand for it

  Model model = Model::phong;
  Specular specular = Specular::reflect;
  FamilyMaterial material, backMaterial;
  FamilyLights lights;
  FamilyPbr pbr;

  /// MultipassSurfaces that we can do ourselves, and where they find input and settings. fxaa: full-screen
  /// anti-aliasing. peelDepths and peel: surfaces that are seen through, drawn once to find the nearest and
  /// farthest of them, and then, peel by peel, to composite them (dual depth peeling): all is traced in the
  /// first peel. peelRest: afterwards, what peels have left, in the order of drawing. sum: the same without
  /// order, colours times opacity and opacities being added up (weighted blending). resolve: full-screen
  /// averages over the samples of a multisampled texture.
  enum class Pass { none, fxaa, peelDepths, peel, peelRest, sum, resolve };
  Pass pass = Pass::none;
  std::string passInput;   // sampler: fxaa and resolve, the picture; peelDepths, green, the depth of what is
                           // opaque, or -1; peel, what peelDepths has found; peelRest, what peels have left
  std::string passOutput;  // of the fragment shader: depths found; colour times opacity, and opacity;
                           // sum, opacity in its red, the colour being the other output
  FamilyValue passSamples, passGamma;  // of resolve: how many; averages are of colours to this power
  FamilyValue relativeContrast, hardContrast, subpixelBlendLimit, subpixelContrast, endpointSearchIterations;

  // Painted edges of triangles, by a geometry shader: flags a triangle, width in pixels, colour.
  std::string edgeFlags;  // buffer sampler; bit k: the edge from corner k to the next
  FamilyValue edgeWidth, edgeColor, edgeOpacity;
  bool edgesGrow = true;        // corners are moved outwards; otherwise they stay
  std::string edgeViewport;     // uniform: x, y, width, height, as the shader takes the viewport to be
  bool geometryShader = false;  // programs of the family have one
  FamilyImpostors impostors;
  bool clipCenters = false;  // clip planes cut impostors away by their centres, or leave them whole
  std::string clipPlanes, clipPlaneCount;  // uniform array of planes in object space, how many of them count
  FamilyValue depthOffset, depthFactor;    // added to window depth: offset, and factor times its slope

  /// Every name that the family mentions, {} for the number of a light, arrays without [{}].
  std::set<std::string, std::less<>> mentioned;
  Alternatives alternatives;  // of names in `mentioned`
  bool mentions(std::string_view name) const;
};

/// Families, the first that fits wins, and the code that they know.
struct FamilyList {
  std::vector<std::shared_ptr<const Family>> families;
  CodeSections code;

  /// Adds those of `more` behind these; sections of the same name become one.
  void append(const FamilyList& more);
  bool empty() const { return families.empty() && code.empty(); }
  size_t size() const { return families.size(); }
  auto begin() const { return families.begin(); }
  auto end() const { return families.end(); }
  const std::shared_ptr<const Family>& front() const { return families.front(); }
  const std::shared_ptr<const Family>& at(size_t i) const { return families.at(i); }
  const std::shared_ptr<const Family>& operator[](size_t i) const { return families[i]; }
};

/// What is wrong with a family file, in one line with file and line number.
struct FamilyError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads a family file's text; `file` names it in errors. Throws FamilyError.
FamilyList parseFamilies(std::string_view text, const std::string& file);

/// Throws FamilyError, with file and line, where a family of `list` names a section that is not in `known`.
void needSections(const FamilyList& list, const CodeSections& known);

/// The families that are built in.
const FamilyList& builtInFamilies();

}  // namespace gluray::gl
