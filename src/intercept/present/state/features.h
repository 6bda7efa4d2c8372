// Capabilities of the current context, read once per context, so that the write-back uses only what exists.
// GL thread, context current.
#pragma once
#include "gl/real/real.h"

namespace gluray::present {

struct Features {
  int version = 0;            // 10 * major + minor
  int glslVersion = 0;        // 100 * major + minor, for instance 120; 0: no GLSL
  bool compatibility = true;  // has fixed function
  int maxDrawBuffers = 1;
  int maxClipDistances = 0;
  int maxTextureSize = 0;           // texels
  int textureUnit = 0;              // first of two units for our use: high, because programs rarely use these
  bool indexedDrawBuffers = false;  // blend enable and colour mask per draw buffer
  bool indexedBlending = false;     // blend functions and equations, too
  bool indexedViewports = false;    // viewport, scissor and depth range per viewport
  bool samplerObjects = false;
  bool multisample = false;  // GL 1.3 coverage state
  bool sampleMask = false;   // glSampleMaski
  bool rasterizerDiscard = false;
  bool transformFeedbackPause = false;
  bool debugOutput = false;
  bool readFramebuffers = false;  // separate read and draw framebuffers
  bool depthBounds = false;
  bool offsetClamp = false;       // glPolygonOffsetClamp
  bool clipControl = false;       // glClipControl
  bool encoding = false;          // GL_FRAMEBUFFER_SRGB
  bool rectangles = false;        // GL_TEXTURE_RECTANGLE
  bool redFloatTextures = false;  // R32F
  bool floatTextures = false;     // LUMINANCE32F_ARB
};

/// Queries the current context. Raises no GL error.
Features readFeatures(const gl::RealGl& real);

}  // namespace gluray::present
