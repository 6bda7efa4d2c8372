// Balls, tubes and discs as triangles: what impostors (scene/impostors.h) become in files of other programs.
// Any thread.
#pragma once
#include "saved/export/arrays/array_source.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace gluray::saved {

/// Of tubes: which of their ends are closed by a disc.
enum class RoundForm : uint8_t { ball, openTube, closedAtFirst, closedAtSecond, closedTube, disc };
constexpr size_t kRoundForms = 6;

/// A ball about end[0], the mantle of a cylinder or cone between both ends, or a disc about end[0] that faces
/// end[1].
struct RoundShape {
  RoundForm form = RoundForm::ball;
  glm::vec3 end[2] = {glm::vec3(0), glm::vec3(0, 0, 1)};
  float radius[2] = {1, 1};
  glm::vec4 color[2] = {glm::vec4(1), glm::vec4(1)};  // at the ends; balls and discs have the first
  /// Whether it is a UnitShape under a matrix, with one colour.
  bool isPlain() const { return form == RoundForm::ball || (radius[0] == radius[1] && color[0] == color[1]); }
  /// The matrix from its UnitShape.
  glm::dmat4 placed() const;
};

/// Radius 1; tubes from z = 0 to 1, discs at z = 0, which face +z.
struct UnitShape {
  std::vector<glm::vec3> positions, normals;  // unit length
  std::vector<uint32_t> indices;
};
/// `quarter`: edges of a quarter of a circle. The six points of balls on the axes are vertices.
UnitShape unitShape(RoundForm, int quarter);

/// The arrays of many shapes of one form in one mesh; read as they are asked for. Null: too many for indices.
struct MergedShapes {
  SourcePtr positions, normals, colors, indices;
};
MergedShapes merged(std::vector<RoundShape> ofOneForm, int quarter);

}  // namespace gluray::saved
