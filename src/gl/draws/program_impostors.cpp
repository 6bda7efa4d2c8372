// Conditions of ProgramDraws on impostors.
#include "gl/draws/program_draws.h"
#include "gl/impostors/pixel_impostors.h"

namespace gluray::gl {

Reason ProgramDraws::classifyImpostors() {
  p_.shadow.shareImpostorValues();
  if (p_.shadow.attributes().shape == scene::Shape::triangles) return Reason::traced;
  if (p_.shadow.attributes().sentBillboards &&
      (p_.shadow.viewport().depthNear != 0 || p_.shadow.viewport().depthFar != 1))
    return Reason::program;
  // Boxes cut off samples of pixels whose centre shows the stick, and each program's boxes do so differently.
  if (p_.shadow.attributes().shape == scene::Shape::sticks && p_.shadow.target().samples > 1)
    return Reason::program;
  // Culling may remove billboards, which have two sides. It removes neither points nor both sides of boxes.
  if (p_.shadow.attributes().shape != scene::Shape::beads &&
      p_.shadow.attributes().shape != scene::Shape::sticks &&
      p_.shadow.raster().cull != scene::CullFace::none)
    return Reason::program;
  if (!scene::isInWindow(p_.shadow.attributes().shape)) return Reason::traced;
  const Reason reason = readPixelImpostors(p_.shadow);
  const bool isPoint = p_.shadow.attributes().shape == scene::Shape::beads;
  return reason == Reason::traced && isPoint ? readCoordinateShift() : reason;
}

/// Implementations of OpenGL differ in the coordinates of multisampled points (Mesa 22: half a pixel aside).
Reason ProgramDraws::readCoordinateShift() {
  const int samples = p_.shadow.target().samples;
  p_.shadow.setCoordinateShift(glm::vec2(0));
  if (samples <= 1) return Reason::traced;
  const auto [known, isNew] = coordinateShifts_.try_emplace(samples);
  if (isNew) {
    p_.shadow.errors.keepPending();
    p_.shadow.current.shelve(p_.shadow.real);
    known->second = p_.pending.presenter.reader().pointCoordinateShift(p_.shadow.real, samples);
    p_.shadow.latch.restore(p_.shadow.real);
  }
  if (!known->second) return Reason::multisampledPoints;
  p_.shadow.setCoordinateShift(*known->second);
  return Reason::traced;
}

}  // namespace gluray::gl
