// VolumeReader: programs whose rays end on the faces, and whose colours are those of one map.
#include "gl/basics/affine.h"
#include "gl/programs/program_functions.h"
#include "gl/real/clip_depths.h"
#include "gl/volumes/volume_look_reader.h"
#include "gl/volumes/volume_reader.h"

#include <cmath>
#include <limits>

namespace gluray::gl {
namespace {

/// Moves points to z = side * w.
glm::dmat4 toEnd(double side) {
  glm::dmat4 m(1);
  m[2][2] = 0, m[3][2] = side;
  return m;
}

}  // namespace

bool VolumeReader::readSpan(scene::VolumeSpan& span) {
  const FamilyVolumeSpan& names = family_.span;
  const KnownProgram& known = *program_.known;
  const auto clip = matrixOf(known, uniforms_, names.clip), view = matrixOf(known, uniforms_, names.view),
             back = matrixOf(known, uniforms_, names.viewInverse);
  if (!clip || !view || !back) return refuse("a function of its positions is not understood");
  clipFromData_ = hasDepthsFromZero(shadow_.real, shadow_.rare()) ? toUsualDepths(*clip) : *clip;
  if (!isInvertible(clipFromData_)) return refuse("a matrix has no inverse");
  span.nearFromData = *back * toEnd(-1) * *view, span.farFromData = *back * toEnd(1) * *view;
  span.depthFromData = *view;
  span.showsDepth = valueOfWord(known.words, names.depthSlot, kVolumeDepths, names.showsDepth);
  span.size = glm::dvec3(value(names.size, glm::vec4(0)));
  span.shift = double{value(names.shift, glm::vec4(0)).x},
  span.step = double{value(family_.step, glm::vec4(0)).x};
  if (!glm::all(glm::greaterThan(span.size, glm::dvec3(0)))) return refuse("its size is not above 0");
  if (!(span.step > 0) || !std::isfinite(span.step)) return refuse("its step is not above 0");
  if (!uniforms_.has(names.window)) return true;
  const auto window = matrixOf(known, uniforms_, names.windowFromPixels);
  if (!window || *window != glm::dmat4(1)) return refuse("its window is not that of pixels");
  span.window = glm::dvec4(uniforms_.vector(names.window));
  return true;
}

bool VolumeReader::readLimits(scene::VolumeLevels& levels) {
  const FamilyVolumeLevels& names = family_.levels;
  levels.limits = value(names.limits, {0, 1, 0, 0});
  levels.gamma = value(names.gamma, glm::vec4(1)).x;
  levels.leastMaximum = value(names.leastMaximum, glm::vec4(levels.leastMaximum)).x;
  levels.mostMinimum = value(names.mostMinimum, glm::vec4(levels.mostMinimum)).x;
  levels.attenuation = value(names.attenuation, glm::vec4(1)).x;
  levels.attenuationStep = value(family_.step, glm::vec4(1)).x;
  levels.threshold = value(names.threshold, glm::vec4(0)).x;
  levels.opacity = value(names.opacity, glm::vec4(1)).x;
  const float width = levels.limits.y - levels.limits.x;
  if (width == 0 || !std::isfinite(width)) return refuse("its limits are equal");
  return levels.gamma > 0 || refuse("its gamma is not above 0");
}

/// Planes of texture space. The function's fourth component does not count.
bool VolumeReader::readPlanes(scene::VolumeLevels& levels) {
  const FamilyVolumeLevels& names = family_.levels;
  const auto nameOf = [](const std::string& name, int number) { return name + std::to_string(number); };
  if (names.planePoint.empty()) return true;
  for (int i = 0; uniforms_.has(nameOf(names.planePoint, i)); ++i) {
    const auto space = matrixOf(*program_.known, uniforms_, names.planeFromData);
    if (!space) return refuse("the function of its planes is not understood");
    const glm::dvec3 point(uniforms_.vector(nameOf(names.planePoint, i))),
        normal(uniforms_.vector(nameOf(names.planeNormal, i)));
    const glm::dvec4 plane = glm::dvec4(normal, 0) * *space + glm::dvec4(0, 0, 0, -glm::dot(normal, point));
    levels.planes.emplace_back(plane * glm::dvec4(glm::dvec3(value(family_.span.size, glm::vec4(1))), 1));
  }
  return true;
}

bool VolumeReader::readLevels(scene::Volume& volume) {
  if (!readLimits(volume.levels) || !readPlanes(volume.levels)) return false;
  // Beyond the limits, maps have any colour.
  if (!uniforms_.has(family_.levels.limits.uniform) && volume.grid->type != scene::VoxelGrid::Type::byte &&
      volume.grid->type != scene::VoxelGrid::Type::word)
    return refuse("its scalars may lie beyond its map of colours");
  volume.cellStep = 1.5f / value(family_.span.size, glm::vec4(1));
  return maps_.read(shadow_, uniforms_, functionOf(*program_.known, family_.color),
                    volume.channels.front().color, why_);
}

bool VolumeReader::readSpanned(scene::VolumeCast& cast) {
  return readSpan(cast.view.span.emplace()) &&
         VolumeLookReader(shadow_, uniforms_, why_).readScalars(cast.volume) && readLevels(cast.volume);
}

}  // namespace gluray::gl
