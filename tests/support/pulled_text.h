// Shader programs like those of VTK's mapper that pulls vertices from buffer textures, composed of the same
// pieces.
#pragma once
#include <string>

namespace gluray::test {

enum class PulledColor { material, points, cells, mapped };
enum class PulledNormals { points, cells, none };
enum class PulledLights { none, headlight, directional, positional };

/// The options of which a program is composed.
struct PulledSurface {
  PulledColor color = PulledColor::material;
  PulledNormals normals = PulledNormals::points;
  PulledLights lights = PulledLights::directional;
  int lightCount = 1;
  bool scalars = true;  // positions and normals in buffers of single floats, as since VTK 9.7
  bool backMaterial = false, clipPlanes = false, depthOffset = false, textured = false;
  bool summed = false;  // order-independent translucency
  bool blocks = false;  // of a composite data set (vtkOpenGLLowMemoryBatchedPolyDataMapper)
};
std::string pulledVertexText(const PulledSurface& surface);
std::string pulledFragmentText(const PulledSurface& surface);

}  // namespace gluray::test
