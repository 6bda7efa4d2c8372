#include "tests/reference/layers/peeler.h"

#include <gtest/gtest.h>

#include <utility>

namespace gluray::test {
namespace {

const char* const kDepthsEarly =
    "  gl_FragDepth = gl_FragCoord.z;\n  ivec2 pixel = ivec2(gl_FragCoord.xy);\n"
    "  float oDepth = texelFetch(opaqueDepth, pixel, 0).y;\n"
    "  if (oDepth != -1. && gl_FragDepth > oDepth)\n"
    "    {\n    fragOutput1.xy = vec2(-1., oDepth);\n    return;\n    }\n"
    "  else\n    {\n    fragOutput1.xy = vec2(-gl_FragDepth, gl_FragDepth);\n    return;\n    }\n";

const char* const kPeelEarly =
    "  gl_FragDepth = gl_FragCoord.z;\n  ivec2 pixelCoord = ivec2(gl_FragCoord.xy);\n"
    "  vec4 front = texelFetch(lastFrontPeel, pixelCoord, 0);\n"
    "  vec2 minMaxDepth = texelFetch(lastDepthPeel, pixelCoord, 0).xy;\n"
    "  float minDepth = -minMaxDepth.x;\n  float maxDepth = minMaxDepth.y;\n"
    "  float epsilon = 0.0000001;\n  fragOutput0 = vec4(0.);\n  fragOutput1 = front;\n"
    "  fragOutput2.xy = vec2(-1.);\n"
    "  if (gl_FragDepth < minDepth - epsilon || gl_FragDepth > maxDepth + epsilon)\n    {\n    return;\n    "
    "}\n"
    "  if (gl_FragDepth > minDepth + epsilon && gl_FragDepth < maxDepth - epsilon)\n"
    "    {\n    fragOutput2.xy = vec2(-gl_FragDepth, gl_FragDepth);\n    return;\n    }\n";

const char* const kPeelLate =
    "  vec4 frag = fragOutput0;\n"
    "  if (gl_FragDepth >= minDepth - epsilon && gl_FragDepth <= minDepth + epsilon)\n    {\n"
    "    fragOutput0 = vec4(0.);\n    front.a = 1. - front.a;\n"
    "    fragOutput1.rgb = front.a * frag.a * frag.rgb + front.rgb;\n"
    "    fragOutput1.a = 1. - (front.a * (1. - frag.a));\n    }\n"
    "  else\n    {\n    frag.rgb *= frag.a;\n    fragOutput0 = frag;\n    }\n";

const char* const kRestEarly =
    "  gl_FragDepth = gl_FragCoord.z;\n  ivec2 pixelCoord = ivec2(gl_FragCoord.xy);\n"
    "  vec2 minMaxDepth = texelFetch(lastDepthPeel, pixelCoord, 0).xy;\n"
    "  float minDepth = -minMaxDepth.x;\n  float maxDepth = minMaxDepth.y;\n"
    "  if (gl_FragDepth < minDepth || gl_FragDepth > maxDepth)\n    {\n    discard;\n    }\n";

std::string inserted(std::string text, const std::string& before, const std::string& what) {
  const size_t at = text.find(before);
  EXPECT_NE(at, std::string::npos);
  return text.insert(at, what);
}

/// The statement before which, or after which, passes have theirs.
std::string startOf(const Surface& surface) {
  return std::string("  vec4 vertexVC = vertexVC") + (surface.edges ? "G" : "V") + "SOutput;\n";
}

std::string depthsText(const Surface& surface) {
  std::string text = fragmentText(surface);
  text = inserted(std::move(text), "void main()", "uniform sampler2D opaqueDepth;\nout vec4 fragOutput1;\n");
  const std::string start = startOf(surface);
  return inserted(std::move(text), start, kDepthsEarly);
}

std::string peelText(const Surface& surface) {
  std::string text = fragmentText(surface);
  text = inserted(std::move(text), "void main()",
                  "uniform sampler2D lastFrontPeel;\nuniform sampler2D lastDepthPeel;\n"
                  "out vec4 fragOutput1;\nout vec4 fragOutput2;\n");
  const std::string start = startOf(surface);
  text.insert(text.find(start) + start.size(), kPeelEarly);
  return text.insert(text.rfind('}'), kPeelLate);
}

std::string restText(const Surface& surface) {
  std::string text = fragmentText(surface);
  text = inserted(std::move(text), "void main()", "uniform sampler2D lastDepthPeel;\n");
  const std::string start = startOf(surface);
  text.insert(text.find(start) + start.size(), kRestEarly);
  return text.insert(text.rfind('}'), "  fragOutput0.rgb *= fragOutput0.a;\n");
}

std::string textOf(Peeler::Stage stage, const Surface& surface) {
  switch (stage) {
    case Peeler::kDepths: return depthsText(surface);
    case Peeler::kPeel: return peelText(surface);
    case Peeler::kRest: return restText(surface);
    default: return fragmentText(surface);
  }
}

const char* const kScreenVertex =
    "#version 150\nin vec4 ndCoordIn;\nin vec2 texCoordIn;\nout vec2 texCoord;\n"
    "void main()\n{\n  gl_Position = ndCoordIn;\n  texCoord = texCoordIn;\n}\n";

GLuint screenProgram(Gl gl, const std::string& body) {
  return makeProgram(gl, kScreenVertex, "#version 150\nin vec2 texCoord;\n" + body);
}

}  // namespace

Peeler::Peeler(Gl gl) : gl_(gl) {
  gl.GenFramebuffers(1, &framebuffer_);
  gl.GenTextures(kTextures, textures_);
  for (int t = 0; t < kTextures; ++t) {
    gl.BindTexture(GL_TEXTURE_2D, textures_[t]);
    const bool depths = t == kDepthA || t == kDepthB;
    if (t != kOpaqueDepth)
      gl.TexImage2D(GL_TEXTURE_2D, 0, depths ? GL_RG32F : GL_RGBA8, kProgramWidth, kProgramHeight, 0,
                    depths ? GL_RG : GL_RGBA, depths ? GL_FLOAT : GL_UNSIGNED_BYTE, nullptr);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }
  gl.GenQueries(1, &query_);
  copyDepth_ = screenProgram(gl,
                             "uniform sampler2D oTex;\nout vec4 fragOutput0;\nout vec4 fragOutput1;\n"
                             "void main()\n{\n  float d = texture(oTex, texCoord).r;\n"
                             "  if (d == 1.) { discard; }\n"
                             "  fragOutput0 = fragOutput1 = vec4(-1., d, 0., 0.);\n}\n");
  blendBack_ = screenProgram(gl,
                             "uniform sampler2D newPeel;\nout vec4 fragOutput0;\n"
                             "void main()\n{\n  vec4 f = texture(newPeel, texCoord);\n"
                             "  if (f.a == 0.) { discard; }\n  fragOutput0 = f;\n}\n");
  merge_ = screenProgram(gl,
                         "uniform sampler2D frontTexture;\nuniform sampler2D backTexture;\n"
                         "out vec4 fragOutput0;\nvoid main()\n{\n"
                         "  vec4 front = texture(frontTexture, texCoord);\n"
                         "  vec4 back = texture(backTexture, texCoord);\n  front.a = 1. - front.a;\n"
                         "  fragOutput0.rgb = (front.rgb + back.rgb * front.a);\n"
                         "  fragOutput0.a = (1. - front.a * (1. - back.a));\n}\n");
  const float corners[] = {-1, -1, 0, 0, 1, -1, 1, 0, -1, 1, 0, 1, 1, 1, 1, 1};  // x, y, s, t
  gl.GenVertexArrays(1, &screen_);
  gl.BindVertexArray(screen_);
  gl.GenBuffers(1, &corners_);
  gl.BindBuffer(GL_ARRAY_BUFFER, corners_);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof corners, corners, GL_STATIC_DRAW);
}

void Peeler::attach(std::initializer_list<Texture> textures) {
  gl_.DrawBuffer(GL_NONE);
  std::vector<GLenum> buffers;
  for (const Texture t : textures) {
    buffers.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size()));
    gl_.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, buffers.back(), GL_TEXTURE_2D, textures_[t], 0);
  }
  gl_.DrawBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
}

void Peeler::clearTo(std::initializer_list<Texture> textures, float red, float green) {
  attach(textures);
  gl_.ClearColor(red, green, 0, 0);
  gl_.Clear(GL_COLOR_BUFFER_BIT);
}

void Peeler::bind(int unit, Texture texture) {
  gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl_.BindTexture(GL_TEXTURE_2D, textures_[texture]);
}

void Peeler::fullScreen(GLuint program, std::initializer_list<std::pair<const char*, int>> samplers) {
  gl_.UseProgram(program);
  for (const auto& [name, unit] : samplers) setInteger(gl_, program, name, unit);
  gl_.BindVertexArray(screen_);
  const auto array = [&](const char* name, size_t offset) {
    const auto location = static_cast<GLuint>(gl_.GetAttribLocation(program, name));
    gl_.EnableVertexAttribArray(location);
    gl_.VertexAttribPointer(location, 2, GL_FLOAT, GL_FALSE, 16, reinterpret_cast<const void*>(offset));
  };
  gl_.BindBuffer(GL_ARRAY_BUFFER, corners_);
  array("ndCoordIn", 0), array("texCoordIn", 8);
  gl_.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void Peeler::draw(Stage stage, const Layer& one, size_t number) {
  Ready& ready = ready_[{stage, number}];
  if (!ready.program) {
    const std::string vertex = vertexText(one.surface);
    ready.program = stage == kOpaque
                        ? makeProgram(gl_, one.surface)
                        : makeProgram(gl_, vertex, textOf(stage, one.surface), geometryText(one.surface));
    ready.upload = upload(gl_, one.mesh, ready.program);
  }
  drawLayer(gl_, ready.program, ready.upload, one, [&] {
    setInteger(gl_, ready.program, "opaqueDepth", 3);
    setInteger(gl_, ready.program, "lastFrontPeel", 4);
    setInteger(gl_, ready.program, "lastDepthPeel", 5);
  });
}

void Peeler::drawAll(Stage stage, const std::vector<Layer>& all, const std::function<void()>& between) {
  bool first = true;
  for (size_t i = 0; i < all.size(); ++i) {
    if ((all[i].opacity == 1) != (stage == kOpaque)) continue;
    if (!first && between) between();
    draw(stage, all[i], i);
    first = false;
  }
}

bool Peeler::peel(const std::vector<Layer>& all, Texture front, Texture frontNext, Texture depths,
                  Texture depthsNext, const Hooks& hooks) {
  clearTo({kBackTemp}, 0, 0);
  clearTo({depthsNext}, -1, -1);
  clearTo({frontNext}, 0, 0);
  attach({kBackTemp, frontNext, depthsNext});
  gl_.BlendEquation(GL_MAX);
  bind(4, front), bind(5, depths);
  drawAll(kPeel, all, peels_ == 0 ? hooks.betweenSurfaces : nullptr);
  if (peels_ == 0 && hooks.afterFirstPeel) hooks.afterFirstPeel();
  ++peels_;
  gl_.BeginQuery(GL_SAMPLES_PASSED, query_);
  attach({kBack});
  for (GLenum i = 1; i < 3; ++i)
    gl_.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + i, GL_TEXTURE_2D, 0, 0);
  bind(4, kBackTemp);
  gl_.BlendEquation(GL_FUNC_ADD);
  gl_.BlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  fullScreen(blendBack_, {{"newPeel", 4}});
  gl_.EndQuery(GL_SAMPLES_PASSED);
  GLuint written = 0;
  gl_.GetQueryObjectuiv(query_, GL_QUERY_RESULT, &written);
  written_.push_back(written);
  return written > threshold;
}

void Peeler::frame(const std::vector<Layer>& all, const Hooks& hooks) {
  beginFrame(gl_);
  drawAll(kOpaque, all);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
  clearTo({kBack, kFrontA}, 0, 0);
  clearTo({kDepthB, kDepthA}, -1, -1);
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  bind(3, kOpaqueDepth);
  gl_.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, 0, 0, kProgramWidth, kProgramHeight, 0);
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
  attach({kDepthB, kDepthA});
  gl_.Disable(GL_BLEND);
  fullScreen(copyDepth_, {{"oTex", 3}});
  attach({kBackTemp, kDepthB});
  bind(3, kDepthA);
  gl_.Enable(GL_BLEND);
  gl_.BlendEquation(GL_MAX);
  drawAll(kDepths, all);
  if (hooks.afterDepths) hooks.afterDepths();
  Texture front = kFrontA, frontNext = kFrontB, depths = kDepthB, depthsNext = kDepthA;
  peels_ = 0;
  written_.clear();
  bool more = true;
  while (more && peels_ < mostPeels) {
    more = peel(all, front, frontNext, depths, depthsNext, hooks);
    std::swap(front, frontNext), std::swap(depths, depthsNext);
  }
  if (blendsRest && written_.back() > 0) {
    gl_.BlendEquation(GL_FUNC_ADD);
    gl_.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    attach({kBack});
    bind(5, depths);
    drawAll(kRest, all);
  }
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  bind(4, front), bind(5, kBack);
  fullScreen(merge_, {{"frontTexture", 4}, {"backTexture", 5}});
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.Enable(GL_DEPTH_TEST);
}

}  // namespace gluray::test
