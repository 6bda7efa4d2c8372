// A picture that goes into a multisampled framebuffer and is not there yet. Programs clear such a
// framebuffer, draw, and resolve it: software OpenGLs take longer over writing and averaging the samples than
// we over tracing them. So the picture waits: where it is resolved, its pixels go where the program wants
// them, and the framebuffer gets its samples only where something else comes. Owned by Context, GL thread.
#pragma once
#include "gl/batch/batch.h"
#include "gl/programs/program_draw.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace gluray::gl {

struct UnresolvedPicture {
  struct Attachment {
    GLenum type = GL_NONE;  // GL_TEXTURE or GL_RENDERBUFFER
    GLuint name = 0;
    bool operator==(const Attachment&) const = default;
  };
  /// A framebuffer object that was cleared and not drawn into since. 0: there is none.
  struct Cleared {
    GLuint framebuffer = 0;
    GLenum drawBuffer = GL_NONE;
    Attachment color, depth;
    glm::ivec4 box{0};          // x, y, width, height that were cleared, to depth 1 and
    uint32_t background = 0;    // this colour
    float depthResolution = 0;  // of the depth buffer

    bool covers(const glm::ivec4& other) const {
      return other.x >= box.x && other.y >= box.y && other.x + other.z <= box.x + box.z &&
             other.y + other.w <= box.y + box.w;
    }
  };
  /// The only one that was drawn there since.
  struct Waiting {
    Cleared cleared;
    BatchKey key;
    scene::SnapshotPtr snapshot;
    std::vector<ProgramDraw> draws;
    bool traced = false;  // already
  };
  Cleared cleared;
  std::optional<Waiting> waiting;

  bool any() const { return cleared.framebuffer != 0 || waiting.has_value(); }
};

}  // namespace gluray::gl
