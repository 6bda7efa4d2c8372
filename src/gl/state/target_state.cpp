// Reads back the state of the draw framebuffer.
#include "gl/real/buffer_bits.h"
#include "gl/real/state_queries.h"
#include "gl/state/state.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace gluray::gl {
namespace {

bool isSingleDrawBuffer(GLenum buffer) {
  switch (buffer) {
    case GL_FRONT:
    case GL_BACK:
    case GL_FRONT_LEFT:
    case GL_BACK_LEFT:
    case GL_FRONT_AND_BACK:
    case GL_LEFT: return true;
    default: return buffer >= GL_COLOR_ATTACHMENT0 && buffer < GL_COLOR_ATTACHMENT0 + 16;
  }
}

enum class Colors { bytes, floats, others };

/// Format of the colour buffer. `bytes`: normalised values of 8 or 10 bits. The write-back delivers 8 bits:
/// of 10 bits the last two are lost, at most a quarter of 1/255.
Colors colorsOf(const RealGl& real, const TargetState& target, bool fixedFunction) {
  const auto fits = [](GLint bits) { return bits == 8 || bits == 10; };
  if (target.framebuffer == 0)
    return fits(redBits(real, target.drawBuffer, fixedFunction)) ? Colors::bytes : Colors::others;
  GLint type = 0, bits = 0;
  real.GetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, target.drawBuffer,
                                           GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &type);
  real.GetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, target.drawBuffer,
                                           GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE, &bits);
  if (type == GL_FLOAT) return Colors::floats;
  return type == GL_UNSIGNED_NORMALIZED && fits(bits) ? Colors::bytes : Colors::others;
}

/// Bits of red, green, blue and alpha.
glm::ivec4 bitsOf(const RealGl& real, const TargetState& target, bool fixedFunction) {
  if (!fixedFunction) return colorBits(real, target.drawBuffer);
  return {integer(real, GL_RED_BITS), integer(real, GL_GREEN_BITS), integer(real, GL_BLUE_BITS),
          integer(real, GL_ALPHA_BITS)};
}

/// Whether all of the buffer's channels have so many bits. Alpha may be missing.
bool haveBits(const glm::ivec4& bits, int each) {
  return glm::ivec3(bits) == glm::ivec3(each) && (bits.a == 0 || bits.a == each);
}

/// Reads the colour buffer's bits, and whether traced surfaces can be blended with its contents.
void readColorBits(const RealGl& real, bool fixedFunction, TargetState& target) {
  const GLenum buffer = target.drawBuffer;
  const bool single = target.framebuffer != 0 || (buffer != GL_FRONT_AND_BACK && buffer != GL_LEFT);
  const glm::ivec4 bits = bitsOf(real, target, fixedFunction);
  target.alpha = bits.a != 0;
  target.eightBits = !target.wideColors && haveBits(bits, 8);
  target.halfFloats = target.wideColors && haveBits(bits, 16);
  const bool known = target.eightBits || target.halfFloats || (target.wideColors && haveBits(bits, 32));
  target.blendable = known && single && target.samples == 1 && !target.encodes;
}

/// Size in pixels of the renderbuffer attached to the framebuffer object; {0, 0} for other images and for
/// deleted names. A deleted renderbuffer may stay attached while its name belongs to another one or to none.
/// Binding such a name would create a new renderbuffer.
glm::ivec2 attachmentSize(const RealGl& real, AttachedImages& images, GLenum attachment) {
  const auto ask = [&](GLenum name) { return attachmentValue(real, GL_DRAW_FRAMEBUFFER, attachment, name); };
  if (ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_RENDERBUFFER ||
      images.mayBeDeleted(real, GL_DRAW_FRAMEBUFFER, attachment))
    return {0, 0};
  return renderbufferSize(real, static_cast<GLuint>(ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME)));
}

/// Whether the depth buffer has a float format; the depth buffers of windows never do.
bool keepsFloats(const RealGl& real, GLuint framebuffer) {
  if (framebuffer == 0) return false;
  const auto ask = [&](GLenum name) {
    return attachmentValue(real, GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, name);
  };
  return ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_NONE &&
         ask(GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT;
}

}  // namespace

void readTarget(const RealGl& real, const RareState& has, AttachedImages& images, TargetState& target) {
  target.size = {0, 0};
  target.reason = Reason::traced;
  target.eightBits = target.halfFloats = target.blendable = false;
  const bool objects = has.framebufferObjects;
  target.framebuffer = objects ? static_cast<GLuint>(integer(real, GL_DRAW_FRAMEBUFFER_BINDING)) : 0;
  target.drawBuffer = static_cast<GLenum>(integer(real, GL_DRAW_BUFFER));
  target.samples = std::max(1, integer(real, GL_SAMPLES));
  target.encodes = has.framebufferSrgb && isOn(real, GL_FRAMEBUFFER_SRGB);
  target.samplePositions.assign(static_cast<size_t>(target.samples), glm::vec2(0.5f));
  if (!isSingleDrawBuffer(target.drawBuffer)) target.reason = Reason::drawBuffer;
  if (target.framebuffer != 0) {
    if (real.CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
      target.reason = Reason::framebuffer;
    if (hasMoreDrawBuffers(real)) target.reason = Reason::drawBuffer;
    target.size = attachmentSize(real, images, target.drawBuffer);
  }
  const GLint depthBits = gl::depthBits(real, has.fixedFunction);
  target.depthResolution = std::ldexp(1.0f, -std::min(std::max(depthBits, 1), 24));
  // OpenGL leaves the unit to the implementation. Mesa's drivers and rasterisers use two depth steps.
  target.offsetUnit = std::ldexp(2.0f, -std::max(depthBits, 1));
  target.depthFloats = target.wideColors = false;
  if (target.reason != Reason::traced) return;
  target.depthFloats = depthBits > 0 && keepsFloats(real, target.framebuffer);
  const Colors colors = colorsOf(real, target, has.fixedFunction);
  target.wideColors = colors == Colors::floats;
  target.depthSteps = target.depthFloats ? 0 : std::ldexp(1.0, depthBits) - 1;
  readColorBits(real, has.fixedFunction, target);
  if (depthBits == 0)
    target.reason = Reason::noDepthBuffer;
  else if (colors == Colors::others)
    target.reason = Reason::framebuffer;
  if (target.samples > 1 && isPresent(real.GetMultisamplefv))
    for (GLuint i = 0; i < static_cast<GLuint>(target.samples); ++i)
      real.GetMultisamplefv(GL_SAMPLE_POSITION, i, glm::value_ptr(target.samplePositions[i]));
  else if (target.samples > 1)
    target.reason = Reason::framebuffer;
}

}  // namespace gluray::gl
