// GLuRay's own transform feedback, which preserves the program's. GL thread, context current.
#pragma once
#include "gl/real/other_program.h"
#include "gl/real/real.h"

#include <GL/gl.h>
#include <GL/glext.h>

namespace gluray::gl {

/// Whether the real OpenGL has transform feedback objects, which preserve the program's state.
bool hasFeedbackObjects(const RealGl& real);

/// During its lifetime, shader program `program` is in use, rasterisation is off, and the transform feedback
/// object `feedback` is bound.
class FeedbackStage {
 public:
  FeedbackStage(const RealGl& real, GLuint program, GLuint feedback);
  ~FeedbackStage();
  FeedbackStage(const FeedbackStage&) = delete;
  FeedbackStage& operator=(const FeedbackStage&) = delete;

 private:
  const RealGl& real_;
  const GLint feedback_, buffer_;
  OtherProgram program_;
};

/// Maps the buffer bound to GL_TRANSFORM_FEEDBACK_BUFFER for reading during its lifetime. The buffer stays
/// bound.
class MappedFeedback {
 public:
  MappedFeedback(const RealGl& real, GLsizeiptr bytes)
      : real_(real), data_(real.MapBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, bytes, GL_MAP_READ_BIT)) {}
  ~MappedFeedback() {
    if (data_) real_.UnmapBuffer(GL_TRANSFORM_FEEDBACK_BUFFER);
  }
  MappedFeedback(const MappedFeedback&) = delete;
  MappedFeedback& operator=(const MappedFeedback&) = delete;
  /// Null if mapping failed.
  const void* data() const { return data_; }

 private:
  const RealGl& real_;
  const void* const data_;
};

}  // namespace gluray::gl
