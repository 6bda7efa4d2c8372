// What the context in hand can do: read once per context, so that the write-back asks for nothing that is not
// there. GL thread, context current.
#pragma once
#include "gl/real.h"

namespace gluray::present {

struct Features {
  int version = 0;            // 10 * major + minor
  int glslVersion = 0;        // 100 * major + minor, for instance 120; 0: no GLSL
  bool compatibility = true;  // fixed function is there
  int maxDrawBuffers = 1;
  int maxClipDistances = 0;
  int maxTextureSize = 0;  // texels
  int textureUnit = 0;     // the first of two units that we use: high, so that programs rarely use them too
  bool indexedDrawBuffers = false;  // blend enable and colour mask per draw buffer
  bool indexedBlending = false;     // blend functions and equations, too
  bool indexedViewports = false;    // viewport, scissor and depth range per viewport
  bool samplerObjects = false;
  bool multisample = false;  // GL 1.3 coverage state
  bool sampleMask = false;   // glSampleMaski
  bool rasterizerDiscard = false;
  bool transformFeedbackPause = false;
  bool debugOutput = false;
  bool readFramebuffers = false;  // one framebuffer to read from beside the one to draw into
  bool depthBounds = false;
  bool offsetClamp = false;       // glPolygonOffsetClamp
  bool encoding = false;          // GL_FRAMEBUFFER_SRGB
  bool rectangles = false;        // GL_TEXTURE_RECTANGLE
  bool redFloatTextures = false;  // R32F
  bool floatTextures = false;     // LUMINANCE32F_ARB
};

/// Asks the current context. Raises no GL error.
Features readFeatures(const gl::RealGl& real);

}  // namespace gluray::present
