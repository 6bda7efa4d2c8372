#include "tests/reference/layers/summer.h"

namespace gluray::test {
namespace {

std::string summedText(const Surface& surface) {
  std::string text = fragmentText(surface);
  text.insert(text.find("void main()"), "out vec4 fragOutput1;\n");
  return text.insert(text.rfind('}'),
                     "  fragOutput0 = vec4(fragOutput0.rgb*fragOutput0.a, fragOutput0.a);\n"
                     "  fragOutput1.r = fragOutput0.a;\n");
}

}  // namespace

Summer::Summer(Gl gl) : gl_(gl) {
  below_ = imageFramebuffer(gl, {imageTexture(gl, GL_RGBA8)});
  colors_ = imageTexture(gl, GL_RGBA32F), opacities_ = imageTexture(gl, GL_R32F);
  sums_ = imageFramebuffer(gl, {colors_, opacities_});
  over_ = makeProgram(
      gl,
      "#version 150\nvoid main() { gl_Position = vec4(gl_VertexID == 1 ? 3. : -1., gl_VertexID == 2 ? 3. : "
      "-1., 0., 1.); }",
      "#version 150\nuniform sampler2D colors, opacities;\nout vec4 fragOutput0;\nvoid main() {\n"
      "  ivec2 at = ivec2(gl_FragCoord.xy);\n  vec4 c = texelFetch(colors, at, 0);\n"
      "  fragOutput0 = vec4(c.rgb / max(texelFetch(opacities, at, 0).r, 0.01), c.a);\n}\n");
  gl.GenVertexArrays(1, &none_);
}

void Summer::frame(const std::vector<Layer>& all) {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, below_);
  beginFrame(gl_);
  for (const Layer& one : all)
    if (one.opacity == 1) drawFresh(gl_, makeProgram(gl_, one.surface), one);
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, sums_);
  gl_.ClearColor(0, 0, 0, 1);
  gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl_.BlitFramebuffer(0, 0, kProgramWidth, kProgramHeight, 0, 0, kProgramWidth, kProgramHeight,
                      GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  gl_.Enable(GL_BLEND);
  gl_.BlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
  gl_.DepthFunc(depthFunc);
  std::vector<std::function<void()>> draws;  // ready, so that nothing but drawing comes between them
  for (const Layer& one : all) {
    if (one.opacity == 1) continue;
    const GLuint program =
        makeProgram(gl_, vertexText(one.surface), summedText(one.surface), geometryText(one.surface));
    draws.push_back([this, program, &one, uploaded = upload(gl_, one.mesh, program)] {
      drawLayer(gl_, program, uploaded, one);
    });
  }
  bool first = true;
  for (const auto& draw : draws) {
    if (!first && between) between();
    first = false;
    gl_.DepthMask(GL_FALSE);
    draw();
    gl_.DepthMask(GL_TRUE);
  }
  gl_.DepthMask(GL_FALSE);
  if (last) last();
  gl_.DepthMask(GL_TRUE);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, below_);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.BlendFuncSeparate(GL_ONE_MINUS_SRC_ALPHA, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_SRC_ALPHA);
  gl_.UseProgram(over_);
  setInteger(gl_, over_, "colors", 4), setInteger(gl_, over_, "opacities", 5);
  gl_.ActiveTexture(GL_TEXTURE4), gl_.BindTexture(GL_TEXTURE_2D, colors_);
  gl_.ActiveTexture(GL_TEXTURE5), gl_.BindTexture(GL_TEXTURE_2D, opacities_);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindVertexArray(none_);
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
  showInWindow(gl_);
  gl_.Enable(GL_DEPTH_TEST), gl_.DepthFunc(GL_LEQUAL);
}

}  // namespace gluray::test
