// Shader programs like those of VTK's OpenGL2 back end, composed of the same pieces.
#pragma once
#include <string>

namespace gluray::test {

/// The options of which a program is composed.
struct Surface {
  enum class Color { uniform, vertex, mapped, cell };
  enum class Normals { vertex, cell, triangle };
  enum class Lights { none, headlight, directional, positional, pbr, pbrHeadlight, pbrPositional };
  Color color = Color::uniform;
  Normals normals = Normals::vertex;
  Lights lights = Lights::directional;
  int lightCount = 1;
  bool overridable = true;  // has OverridesColor, as the programs of composite data sets have
  /// backMaterial with vertex colours: as in glyphs, which replace the colours of both sides.
  bool backMaterial = false, clipPlanes = false, depthOffset = false, actorTexture = false;
  /// Of physically based materials: textures of base colour, material and emission; a normal map; images of
  /// an environment with irradiance as spherical harmonics or as a cube map.
  bool pbrTextures = false, normalMap = false;
  enum class Environment { none, harmonics, cube };
  Environment environment = Environment::none;
  /// As in VTK since 9.3: the map is looked up at colorTCoord. tcoordMatrix: tcMatrix acts on all of
  /// them.
  bool colorTcoord = false, tcoordMatrix = false;
  /// As in VTK 9.7 and f3d 4. recent: the distribution of normals has a floor, light of environments is
  /// scattered several times and has a factor, colours that are not the material's are raised to 2.2, and
  /// unlit results to 1/2.2. baseTexture: of unlit surfaces, multiplies diffuse colours.
  bool recent = false, baseTexture = false;
  /// All edges are painted, by a geometry shader, as in VTK since 9.4. Not with vertex colours or textures.
  bool edges = false;
  std::string version = "#version 150\n";
};
std::string vertexText(const Surface& surface);
std::string fragmentText(const Surface& surface);
/// Empty if there is none.
std::string geometryText(const Surface& surface);

}  // namespace gluray::test
