#include "tests/fuzz/calls.h"

#include <utility>

namespace gluray::fuzz {
namespace {

constexpr GLuint kObjects = 2, kQueries = 2;  // framebuffers and renderbuffers; queries

GLenum framebufferTarget(Player& p) {
  return p.pick({GL_FRAMEBUFFER, GL_FRAMEBUFFER, GL_DRAW_FRAMEBUFFER, GL_READ_FRAMEBUFFER});
}

void renderMode(Player& p, GLenum mode) {
  if (!p.compiling) p.gl.RenderMode(mode);  // avoided.md; its answer, too
}

const Op kTargetOps[] = {
    {"BindFramebuffer", 6,
     [](Player& p) {
       const GLenum which = framebufferTarget(p);
       p.gl.BindFramebuffer(which, p.name(kObjects));
     }},
    {"BindFramebuffer 0", 12, [](Player& p) { p.gl.BindFramebuffer(GL_FRAMEBUFFER, 0); }},
    {"texture framebuffer", 4,
     [](Player& p) {
       p.gl.Finish();  // avoided.md
       p.gl.BindTexture(GL_TEXTURE_2D, 11);
       p.gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kSize, kSize, 0, GL_RGBA, GL_UNSIGNED_BYTE, p.read());
       p.gl.FramebufferTexture2D(framebufferTarget(p), GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 11, 0);
     }},
    {"FramebufferTexture2D", 2,
     [](Player& p) {
       const GLenum which = framebufferTarget(p);
       p.gl.FramebufferTexture2D(which, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, p.below(4), 0);
     }},
    {"renderbuffer", 4,
     [](Player& p) {
       const GLuint name = p.name(kObjects);
       p.gl.Finish();  // avoided.md
       p.gl.BindRenderbuffer(GL_RENDERBUFFER, name);
       p.gl.RenderbufferStorage(GL_RENDERBUFFER,
                                p.pick({GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT24, GL_RGBA8}), kSize, kSize);
       const GLenum which = framebufferTarget(p);
       p.gl.FramebufferRenderbuffer(which,
                                    p.pick({GL_DEPTH_ATTACHMENT, GL_DEPTH_ATTACHMENT, GL_COLOR_ATTACHMENT0}),
                                    GL_RENDERBUFFER, name);
     }},
    {"CheckFramebufferStatus", 3,
     [](Player& p) {
       const GLenum which = framebufferTarget(p);
       if (p.executing) return;  // avoided.md
       p.answer("CheckFramebufferStatus", {static_cast<double>(p.gl.CheckFramebufferStatus(which))});
     }},
    {"BlitFramebuffer", 2,
     [](Player& p) {
       p.gl.BlitFramebuffer(0, 0, kSize, kSize, 0, 0, kSize, kSize, GL_COLOR_BUFFER_BIT, GL_NEAREST);
     }},
    {"DeleteFramebuffers", 1,
     [](Player& p) {
       const GLuint name = p.name(kObjects);
       p.gl.DeleteFramebuffers(1, &name);
     }},
    {"DeleteRenderbuffers", 1,
     [](Player& p) {
       const GLuint name = p.name(kObjects);
       p.gl.DeleteRenderbuffers(1, &name);
     }},
    {"DrawBuffer", 2,
     [](Player& p) {
       p.gl.DrawBuffer(p.pick({GL_FRONT, GL_FRONT, GL_NONE, GL_COLOR_ATTACHMENT0, GL_BACK}));
     }},
    {"ReadBuffer", 2,
     [](Player& p) {
       p.gl.ReadBuffer(p.pick({GL_FRONT, GL_FRONT, GL_COLOR_ATTACHMENT0}));
     }},
};

const Op kQueryOps[] = {
    {"BeginQuery", 3,
     [](Player& p) {
       const GLuint name = p.name(kQueries);
       p.gl.BeginQuery(p.pick({GL_SAMPLES_PASSED}), name);
     }},
    {"EndQuery", 4, [](Player& p) { p.gl.EndQuery(p.pick({GL_SAMPLES_PASSED})); }},
    {"GetQueryiv", 1,
     [](Player& p) {
       GLint got = -5;
       p.gl.GetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &got);
       p.answer("GetQueryiv", {static_cast<double>(got)});
     }},
    {"GetQueryObjectuiv", 1,
     [](Player& p) {
       GLuint got = 0;
       p.gl.GetQueryObjectuiv(p.name(kQueries), GL_QUERY_RESULT, &got);
     }},
    {"SelectBuffer", 3,
     [](Player& p) {
       auto& memory = p.sink().selection;
       p.gl.SelectBuffer(static_cast<GLsizei>(memory.size()), memory.data());
     }},
    {"FeedbackBuffer", 3,
     [](Player& p) {
       auto& memory = p.sink().feedback;
       p.gl.FeedbackBuffer(static_cast<GLsizei>(memory.size()),
                           p.pick({GL_2D, GL_3D, GL_3D_COLOR, GL_4D_COLOR_TEXTURE}), memory.data());
     }},
    {"RenderMode", 3,
     [](Player& p) {
       renderMode(p, p.pick({GL_SELECT, GL_FEEDBACK}));
     }},
    {"RenderMode GL_RENDER", 8, [](Player& p) { renderMode(p, GL_RENDER); }},
    {"InitNames", 2, [](Player& p) { p.gl.InitNames(); }},
    {"PushName", 4, [](Player& p) { p.gl.PushName(p.below(9)); }},
    {"LoadName", 3, [](Player& p) { p.gl.LoadName(p.below(9)); }},
    {"PopName", 3, [](Player& p) { p.gl.PopName(); }},
    {"PassThrough", 1, [](Player& p) { p.gl.PassThrough(p.real()); }},
};

const Op kFrameOps[] = {
    {"Clear", 10,
     [](Player& p) {
       static constexpr GLbitfield kMasks[] = {GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT,
                                               GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_DEPTH_BUFFER_BIT,
                                               GL_STENCIL_BUFFER_BIT, 0x80000000u};
       p.gl.Clear(kMasks[p.below(std::size(kMasks))]);
     }},
    {"Finish", 6, [](Player& p) { p.gl.Finish(); }},
    {"Flush", 4, [](Player& p) { p.gl.Flush(); }},
    {"context", 2,
     [](Player& p) {
       // Begin, list and query belong to the old context, whose state switchTo() forgets.
       const uint32_t which = p.below(2);
       if (!p.insideBegin && !p.compiling) p.switchTo(which);
     }},
};

}  // namespace

Ops targetCalls() { return kTargetOps; }
Ops queryCalls() { return kQueryOps; }
Ops frameCalls() { return kFrameOps; }

}  // namespace gluray::fuzz
