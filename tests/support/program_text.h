// Shader programs like those of VTK's OpenGL2 back end, composed of the same pieces.
#pragma once
#include <string>

namespace gluray::test {

/// The options of which a program is composed.
struct Surface {
  enum class Color { uniform, vertex, mapped, cell };
  enum class Normals { vertex, cell, triangle };
  enum class Lights { none, headlight, directional, positional, pbr, pbrHeadlight };
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
  std::string version = "#version 150\n";
};
std::string vertexText(const Surface& surface);
std::string fragmentText(const Surface& surface);

}  // namespace gluray::test
