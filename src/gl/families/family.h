// Program families: descriptions, as data, of shader programs that we can trace. A family lists the active
// variables by which a shader program is recognised, and which of them hold geometry, matrices, material and
// lights. Files: spec/programs/*.toml (built in) and those of --program-families; format:
// docs/program-families.md.
#pragma once
#include "gl/families/family_light.h"
#include "gl/families/family_pulling.h"
#include "gl/families/family_volume.h"
#include "gl/families/known_code.h"
#include "gl/glsl/glsl_branches.h"
#include "scene/fragment_shading.h"
#include "scene/impostors.h"
#include "scene/mesh.h"
#include "scene/shading.h"

#include <array>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace gluray::gl {

/// Impostors that the shader program's shaders cut out of billboards.
struct FamilyImpostors {
  scene::Shape shape = scene::Shape::triangles;  // triangles: no impostors
  FamilyValue radius;                            // `uniform` may name an attribute instead
  std::string axis;                              // attribute; its length is the length of the cylinder
  FamilyValue inside;                            // negative: the far side of spheres is visible
  FamilyValue radiusDivisor, outline;            // scene::Impostors
  scene::Impostors::Billboards billboards = scene::Impostors::Billboards::silhouette;
  bool fades = false;
  bool antialiased = false;  // scene::Impostors
  /// Each instance of a draw is an impostor, and its four vertices are the corners of the billboard.
  bool instances = false;
  bool gaussian = false;                           // scene::Impostors
  bool grows = false;                              // of tubes
  FamilyValue size, bulge, bulgeDepth, depthBias;  // of beads and tubes: scene::Impostors
  bool inPixels = false;       // of tubes: scene::Impostors; `size` is one number, as of beads
  FamilyValue longer;          // of these tubes: scene::Impostors
  std::string viewport;        // uniform: the viewport that the program computes with
  FamilyValue scale;           // factor of splats' radius
  FamilyValue lowpass;         // of splats: scene::Impostors
  FamilyValue billboardScale;  // of splats' billboards, in radii
  std::string projection;      // uniform: projection matrix of splats and sent billboards
  /// The program sends the billboards' corners, each with all attributes of its impostor.
  bool sent = false;
  std::string corners;            // attribute: the vertex's corner, as one bit for each direction
  bool parallelView = false;      // the viewer is at infinity; otherwise at the origin
  bool radiusInPosition = false;  // the position's fourth component is the radius
  bool radiusInCorners = false;   // `corners` is a vec2: minus or plus the radius for each direction
  bool hemispheres = false;       // scene::Impostors; the viewer is where the projection has it
  bool radiusInObject =
      false;  // radii are in object space: divided by the length of normalMatrix's first column
  bool zeroScaleIsOne = false;           // a `scale` of 0 has no effect
  std::string end, endColor;             // of sticks: attributes of their second ends
  std::string caps;                      // of sticks: attribute, bits
  std::string roundCaps;                 // of sticks: uniform; 0: round ends are flat
  std::vector<FamilyValue> halvesBlend;  // of sticks: factors whose product is scene::Impostors::halvesBlend
  bool given() const { return shape != scene::Shape::triangles; }
};

/// Maps a family's name of a variable to alternative names in shader programs, the preferred one first.
using Alternatives = std::map<std::string, std::vector<std::string>, std::less<>>;

/// Maps uniforms to the value, given column by column, at which they have no effect. One number applies to
/// all components; no number means the identity matrix.
using NeutralValues = std::map<std::string, std::vector<float>, std::less<>>;

/// Colours by a coordinate in object space (scene::HeightColors). Without scale[0] there are none.
struct FamilyHeight {
  int axis = 2;
  FamilyValue scale[3], offset[3], exponent[3];
  bool given() const { return scale[0].given(); }
};

/// A key of a family that takes one of several words from a group of slots in the program's statements.
struct SlotChoice {
  std::string key, slot;  // the slot with "@"
  std::vector<std::string> words;
  bool has(std::string_view word) const;
};

struct Family {
  enum class Model { unlit, phong, pbr };
  /// The cosine to which the highlight's exponent applies: between reflected ray and viewer, or between
  /// normal and half vector.
  enum class Specular { reflect, half };
  /// How to treat shader programs without vertex normals: refuse them, or use the triangles' normals.
  enum class NoNormals { refuse, triangle };

  std::string name;
  std::string rasteriseBecause;                     // if not empty, why its programs are never traced
  std::vector<std::string> sourceHas, sourceLacks;  // texts that the source must have, must not have
  std::vector<std::string> active, any, absent;     // names of active variables: all of, one of, none of
  std::vector<std::string> absentOutputs;           // fragment shader outputs that must not exist
  std::vector<std::string> ignored;                 // may be active, but do not affect the image
  NeutralValues neutral;                            // do not affect the image at these values
  /// Values of uniforms, which every traced draw has, and of local variables of main. Conditions that follow
  /// from them are decided before statements are compared (gl/glsl/glsl_branches.h).
  DecidedValues decided;
  std::vector<std::string> code;    // sections that contain all statements of the program; empty: any code
  bool wholeMain = false;           // main is compared as one statement
  bool resolvesConditions = false;  // statements are compared after #ifdef and the like
  std::string codeAt;               // file and line that name them
  bool onlySolids = false;          // describes only draws of lines and points that settings turn into solids
  bool strict = true;  // a program with an active variable that the family does not mention does not fit

  std::string position, normal, color, texcoord, tangent;        // attributes
  std::string instanceTransform, instanceNormal, instanceColor;  // per-instance attributes
  std::string instanceShift;                                     // per-instance: a position and a scale
  bool instanceTurnsNormals = false;  // instanceTransform's inverse transpose applies to normals
  FamilyPulling pulling;
  FamilyVolume volume;
  std::vector<std::string> clipFromObject, eyeFromObject;  // uniforms or functions, from left to right
  std::string viewer;  // uniform: viewer position in the space after eyeFromObject; empty: its origin
  /// Function to the space after eyeFromObject from one in which lines of sight run along z; gives the
  /// viewer.
  std::string linesOfSight;
  std::vector<std::string> eyeAgain;  // their product must be that of eyeFromObject, up to a factor
  std::string normalMatrix;           // uniform; empty: inverse transpose of eyeFromObject
  NoNormals withoutNormals = NoNormals::refuse;
  bool flipBackFaces = false;  // back faces are lit with the reversed normal
  std::string flipsBackFaces;  // uniform; not 0: as flipBackFaces
  bool facesViewer = false;    // scene::FragmentShading
  bool flipsTriangles = false;
  bool derivedNormals = false;  // triangle normals are cross products of derivatives in the window
  bool darkBackFaces = false;   // back faces whose normals are not reversed have ambient light only
  scene::FragmentShading::UnitNormals unitNormals = scene::FragmentShading::UnitNormals::pixels;
  std::string parallelView;  // uniform, not 0: the viewer is at infinity (for triangle normals)

  std::string colorMap;         // sampler: its colour at the texture coordinate replaces the surface's colour
  FamilyValue mapLow, mapHigh;  // coordinates of the map's start and end; 0 and 1 if not given
  std::string mapTexcoord;      // attribute: texture coordinate of the map; empty: `texcoord`
  std::string texcoordMatrix;   // uniform, applied to all texture coordinates before they are interpolated
  std::string triangleColors;   // buffer sampler: one colour per triangle
  std::string triangleNormals;
  std::string triangleOffset;       // uniform, added to the triangle's number
  std::string uniformColors;        // uniform; not 0: the material's colours replace all others
  bool colorIsDiffuseOnly = false;  // false: the colour replaces the ambient colour, too
  FamilyHeight height;
  FamilyValue rimColor, rimExponent, rimOpacity;      // scene::Rim; none without a colour or opacity
  FamilyValue colorExponent;                          // of colours that are not the material's
  FamilyValue encoding;                               // unlit: the result is raised to 1 divided by this
  std::vector<std::string> matcap;                    // samplers: scene::FragmentShading
  FamilyValue backFactor;                             // unlit: factor of the colour of back faces
  bool normalColors = false;                          // red, green and blue are half the normal plus a half
  bool clampedColors = false;                         // vertex colours are clamped to [0, 1]
  bool colorAlpha = true;                             // the alpha of vertex colours counts
  bool opaqueColors = false, colorsFromZero = false;  // no draws with other vertex colours
  std::string texturesOnBack;                         // uniform; 0: back faces have no textures
  FamilyValue backColor;                              // of back faces, without lights, textures and fog
  std::string backColorIf;                            // uniform; 0: they have none
  std::vector<std::string> textures;                  // samplers; multiply the lit colour, or
  bool texturesFirst = false;                         // the base colour, before it is lit
  bool texturesDiffuseOnly = false;   // with texturesFirst: only its diffuse use, and not its alpha
  bool texturesReplaceAlpha = false;  // where there is one, the colour's alpha does not count
  std::string texturesIf;             // uniform; 0: no textures
  std::string anyTexture;  // one of `textures`; the program may have a sampler2D of any name for it

  Model model = Model::phong;
  Specular specular = Specular::reflect;
  FamilyMaterial material, backMaterial;
  std::string discardsInvisibleInSource;  // text in the source of programs that discard an alpha of 0
  FamilyLights lights;
  FamilyPbr pbr;
  FamilyFog fog;

  /// Passes that we can make ourselves. fxaa: full-screen anti-aliasing. Dual depth peeling: peelDepths finds
  /// the nearest and farthest depths of layers; peel composites them, peel by peel (all are traced in the
  /// first one); peelRest then blends the remaining layers in drawing order. sum: adds layers without order,
  /// colour times opacity and opacity (weighted blending). resolve: full-screen averages over the samples of
  /// a multisampled texture.
  enum class Pass { none, fxaa, peelDepths, peel, peelRest, sum, resolve };
  Pass pass = Pass::none;
  std::string passInput;   // sampler. fxaa, resolve: the image; peelDepths: opaque depth in green, or -1;
                           // peel: depths that peelDepths found; peelRest: depths of the remaining layers
  std::string passOutput;  // fragment shader output. peelDepths: depths; peel: colour times opacity, and
                           // opacity; sum: opacity in red (the other output is the colour)
  std::string passTexel;   // uniform of fxaa: width and height of the image's pixels, as texture coordinates
  FamilyValue passSamples, passGamma;  // of resolve: sample count; power of colours before they are averaged
  FamilyValue relativeContrast, hardContrast, subpixelBlendLimit, subpixelContrast, endpointSearchIterations;

  // Edges of triangles that a geometry shader paints: flags per triangle, width in pixels, colour.
  std::string edgesIf;          // uniform; 0: no edges
  std::string edgesUnless;      // uniform; not 0: edges have another look, which cannot be traced
  std::string edgeFlags;        // buffer sampler; bit k: the edge from corner k to the next
  std::string edgeFlagsIf;      // uniform; 0: all edges are painted
  std::string edgeFlagsOffset;  // uniform, added to the triangle's number
  FamilyValue edgeWidth, edgeColor, edgeOpacity;
  bool edgesAlone = false, edgesGrow = true;  // scene::FragmentShading
  std::string edgeViewport;     // uniform: x, y, width, height of the viewport that the shader assumes
  bool geometryShader = false;  // programs of the family have one
  FamilyValue
      lineSize;  // onlySolids: width of lines in normalised device coordinates, along x; none: glLineWidth
  FamilyImpostors impostors;
  bool clipCenters = false;  // clip planes remove whole impostors by their centres
  /// Uniform: least and greatest x, least and greatest y of drawn pixels; a function that must be the
  /// identity.
  std::string clipWindow, windowFromPixels;
  std::string clipPlanes, clipPlaneCount;  // uniform array of planes in object space; number of active ones
  FamilyValue depthOffset, depthFactor;    // added to window depth: offset, and factor times its slope

  /// All names that the family mentions, with {} for the number of a light, arrays also without [{}].
  std::set<std::string, std::less<>> mentioned;
  Alternatives alternatives;  // of names in `mentioned`
  bool mentions(std::string_view name) const;
  /// Whether its shader programs take their vertices from fixed function's attributes (gl_Vertex ...).
  bool hasBuiltInVertices() const;
  /// Whether its shader programs draw lines alone, though not always by primitives of lines.
  bool drawsLines() const { return pulling.lines || lineSize.given(); }
  std::vector<SlotChoice> slotChoices() const;
  bool hasRim() const { return rimColor.given() || rimOpacity.given(); }
};

/// Families, of which the first that fits wins, and their known code.
struct FamilyList {
  std::vector<std::shared_ptr<const Family>> families;
  CodeSections code;

  /// Appends the families of `more`; merges sections of equal names.
  void append(const FamilyList& more);
  bool empty() const { return families.empty() && code.empty(); }
  size_t size() const { return families.size(); }
  auto begin() const { return families.begin(); }
  auto end() const { return families.end(); }
  const std::shared_ptr<const Family>& front() const { return families.front(); }
  const std::shared_ptr<const Family>& at(size_t i) const { return families.at(i); }
  const std::shared_ptr<const Family>& operator[](size_t i) const { return families[i]; }
};

/// A mistake in a family file, in one line with file and line number.
struct FamilyError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Parses a family file's text; `file` names it in errors. Throws FamilyError.
FamilyList parseFamilies(std::string_view text, const std::string& file);

/// Throws FamilyError, with file and line, if a family of `list` names a section that is not in `known`, or
/// if its sections have slots that do not fit together.
void needSections(const FamilyList& list, const CodeSections& known);

/// Throws FamilyError if sections that `more` adds to, and that families of `list` name, have such slots.
void needSlots(const FamilyList& list, const CodeSections& more, const CodeSections& known);

/// The built-in families.
const FamilyList& builtInFamilies();

}  // namespace gluray::gl
