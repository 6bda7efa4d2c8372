// StateGuard: pixel transfers from and to memory.
#include "intercept/present/state/state_guard.h"

namespace gluray::present {

using gl::RealGl;

void StateGuard::pixelStore(GLenum name, GLint value) {
  const GLint was = integer(name);
  if (was == value) return;
  keep({[](const RealGl& r, const Undo& u) { r.PixelStorei(u.name, u.i[0]); }, name, 0, {was}});
  real_.PixelStorei(name, value);
}

void StateGuard::pixelTransfer(GLenum name, GLfloat value) {
  GLfloat was = value;
  real_.GetFloatv(name, &was);
  if (was == value) return;
  keep({[](const RealGl& r, const Undo& u) { r.PixelTransferf(u.name, static_cast<GLfloat>(u.d[0])); },
        name,
        0,
        {},
        {was}});
  real_.PixelTransferf(name, value);
}

void StateGuard::plainUnpack(int rowLength) {
  pixelStore(GL_UNPACK_SWAP_BYTES, 0);
  pixelStore(GL_UNPACK_ROW_LENGTH, rowLength);
  pixelStore(GL_UNPACK_SKIP_ROWS, 0);
  pixelStore(GL_UNPACK_SKIP_PIXELS, 0);
  pixelStore(GL_UNPACK_ALIGNMENT, 4);
  if (features_.version >= 12) {
    pixelStore(GL_UNPACK_IMAGE_HEIGHT, 0);
    pixelStore(GL_UNPACK_SKIP_IMAGES, 0);
  }
  plainTransfer();
  unbindBuffer(GL_PIXEL_UNPACK_BUFFER, GL_PIXEL_UNPACK_BUFFER_BINDING);
}

void StateGuard::plainPack() {
  pixelStore(GL_PACK_SWAP_BYTES, 0);
  pixelStore(GL_PACK_ROW_LENGTH, 0);
  pixelStore(GL_PACK_SKIP_ROWS, 0);
  pixelStore(GL_PACK_SKIP_PIXELS, 0);
  pixelStore(GL_PACK_ALIGNMENT, 4);
  plainTransfer();
  unbindBuffer(GL_PIXEL_PACK_BUFFER, GL_PIXEL_PACK_BUFFER_BINDING);
}

void StateGuard::plainTransfer() {
  if (!features_.compatibility) return;
  pixelTransfer(GL_MAP_COLOR, 0);
  for (GLenum scale : {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE, GL_DEPTH_SCALE})
    pixelTransfer(scale, 1);
  for (GLenum bias : {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS, GL_DEPTH_BIAS})
    pixelTransfer(bias, 0);
}

void StateGuard::unbindBuffer(GLenum target, GLenum binding) {
  if (features_.version < 21) return;
  const GLint buffer = integer(binding);
  if (buffer == 0) return;
  keep({[](const RealGl& r, const Undo& u) { r.BindBuffer(u.name, static_cast<GLuint>(u.i[0])); },
        target,
        0,
        {buffer}});
  real_.BindBuffer(target, 0);
}

}  // namespace gluray::present
