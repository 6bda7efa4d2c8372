// WriteBack: opacities of black.
#include "base/timeline.h"
#include "intercept/present/write_back/write_back.h"

namespace gluray::present {

bool WriteBack::uploadTaken(StateGuard& guard, const TakenLight& taken) {
  const int unit = features_.textureUnit;
  const GLenum format = features_.compatibility ? GL_ALPHA : GL_RED;
  guard.plainUnpack(taken.rowBytes);
  if (!makePlane(guard, unit, color_, features_.compatibility ? GL_ALPHA8 : GL_R8, format, GL_UNSIGNED_BYTE,
                 taken.width, taken.height))
    return false;
  for (const frame::Band& band : taken.bands)
    real_.TexSubImage2D(GL_TEXTURE_2D, 0, band.x, band.y, band.width, band.height, format, GL_UNSIGNED_BYTE,
                        taken.at(band.x, band.y));
  return true;
}

bool WriteBack::writeTaken(const TakenLight& taken, const WriteBackTarget& target, PendingErrors& pending) {
  const timeline::Span span("write back");
  std::string why;
  pending = takeErrors(real_);
  if (colors_ != Colors::taken || !ready(why)) return false;
  if (taken.width > features_.maxTextureSize || taken.height > features_.maxTextureSize) return false;
  if (taken.bands.empty()) return true;
  StateGuard guard(real_, features_);
  if (!uploadTaken(guard, taken)) return false;
  WriteBackTarget into = target;
  into.depths = false;
  openFor(guard, into);
  guard.viewport(taken.x, taken.y, taken.width, taken.height);
  guard.scissor(taken.x, taken.y, taken.width, taken.height);
  useProgram(guard);
  {
    StateGuard over(real_, features_);
    over.depthWrites(false);
    over.blendOver();
    draw({taken.x, taken.y}, taken.width, taken.height, {0, 0, taken.bands});
  }
  return real_.GetError() == GL_NO_ERROR;
}

}  // namespace gluray::present
