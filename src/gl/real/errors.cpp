#include "gl/real/errors.h"

#include <utility>

namespace gluray::gl {

void Errors::set(GLenum error) {
  if (error_ != GL_NO_ERROR) return;
  // A second glBegin between the real glBegin and glEnd raises this error, in order with the real OpenGL's
  // other errors.
  if (beginEnd_.realIsInside() && error == GL_INVALID_OPERATION) return real_.Begin(GL_POINTS);
  // The real glGetError must not be called between glBegin and glEnd.
  const bool inside = beginEnd_.inside == BeginEnd::Inside::rasterised || beginEnd_.executedInside();
  const GLenum older = inside ? GLenum{GL_NO_ERROR} : real_.GetError();
  error_ = older != GL_NO_ERROR ? older : error;
}

GLenum Errors::takeError() {
  const GLenum below = real_.GetError();
  return error_ != GL_NO_ERROR ? std::exchange(error_, GL_NO_ERROR) : below;
}

GLenum Errors::takeReal() {
  const GLenum oldest = real_.GetError();
  for (GLenum more = oldest; more != GL_NO_ERROR;) more = real_.GetError();
  return oldest;
}

}  // namespace gluray::gl
