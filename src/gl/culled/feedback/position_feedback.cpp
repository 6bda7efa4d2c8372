#include "gl/culled/feedback/position_feedback.h"

#include "gl/culled/clusters/assembly.h"
#include "gl/state/extensions.h"
#include "gl/state/state_queries.h"

#include <GL/glext.h>

namespace gluray::gl {
namespace {

constexpr GLsizeiptr kMostBytes = GLsizeiptr{1} << 30;

/// While it lives, another program is in use, nothing is rasterised, and feedback goes elsewhere.
class FeedbackStage {
 public:
  FeedbackStage(const RealGl& real, GLuint program, GLuint feedback)
      : real_(real),
        program_(integer(real, GL_CURRENT_PROGRAM)),
        feedback_(integer(real, GL_TRANSFORM_FEEDBACK_BINDING)),
        buffer_(integer(real, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING)) {
    real.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, feedback);
    real.UseProgram(program);
    real.Enable(GL_RASTERIZER_DISCARD);
  }
  ~FeedbackStage() {
    real_.Disable(GL_RASTERIZER_DISCARD);
    real_.UseProgram(static_cast<GLuint>(program_));
    real_.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, static_cast<GLuint>(feedback_));
    real_.BindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, static_cast<GLuint>(buffer_));
  }
  FeedbackStage(const FeedbackStage&) = delete;
  FeedbackStage& operator=(const FeedbackStage&) = delete;

 private:
  const RealGl& real_;
  const GLint program_, feedback_, buffer_;
};

struct MappedBuffer {
  explicit MappedBuffer(const RealGl& real) : real_(real) {}
  ~MappedBuffer() { real_.UnmapBuffer(GL_TRANSFORM_FEEDBACK_BUFFER); }
  MappedBuffer(const MappedBuffer&) = delete;
  MappedBuffer& operator=(const MappedBuffer&) = delete;
  const RealGl& real_;
};

bool hasFeedbackObjects(const RealGl& real) {
  if (!isPresent(real.BindTransformFeedback) || !isPresent(real.TransformFeedbackVaryings)) return false;
  const int version = versionOf(real);
  return version >= 40 || (version >= 30 && hasExtension(real, version, "GL_ARB_transform_feedback2"));
}

/// Whether the program feeds back vertices itself.
bool isFeedingBack(const RealGl& real) {
  return integer(real, GL_TRANSFORM_FEEDBACK_ACTIVE) != 0 || isOn(real, GL_RASTERIZER_DISCARD);
}

}  // namespace

bool PositionFeedback::works(const RealGl& real) {
  if (!copy_ && hasFeedbackObjects(real)) copy_.emplace(real, original_);
  return copy_ && copy_->works();
}

bool PositionFeedback::draw(const RealGl& real, uint32_t first, uint32_t count, GLsizeiptr bytes) {
  copy_->copyUniforms(real);
  const WithoutRestart withoutRestart(real);
  if (bytes > size_) {
    real.BindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, buffer_);
    real.BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, bytes, nullptr, GL_STREAM_READ);
    size_ = bytes;
  }
  real.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer_);
  real.BeginTransformFeedback(GL_POINTS);
  real.DrawArrays(GL_POINTS, static_cast<GLint>(first), static_cast<GLsizei>(count));
  real.EndTransformFeedback();
  return real.GetError() == GL_NO_ERROR;
}

bool PositionFeedback::capture(const RealGl& real, uint32_t first, uint32_t end,
                               const std::function<void(const std::byte*)>& take) {
  const auto bytes = static_cast<GLsizeiptr>(uint64_t{end - first} * kStride);
  if (end <= first || bytes > kMostBytes || end > uint32_t{1} << 30) return false;
  if (!works(real) || isFeedingBack(real)) return false;
  if (feedback_ == 0) real.GenTransformFeedbacks(1, &feedback_), real.GenBuffers(1, &buffer_);
  const FeedbackStage stage(real, copy_->name(), feedback_);
  const bool drawn = draw(real, first, end - first, bytes);
  const void* const at =
      drawn ? real.MapBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, bytes, GL_MAP_READ_BIT) : nullptr;
  if (!at) {
    size_ = 0;
    while (real.GetError() != GL_NO_ERROR) {}
    return false;
  }
  const MappedBuffer mapped(real);
  take(static_cast<const std::byte*>(at));
  return true;
}

void PositionFeedback::release(const RealGl& real) {
  if (copy_) copy_->release(real);
  if (feedback_ != 0) real.DeleteTransformFeedbacks(1, &feedback_), real.DeleteBuffers(1, &buffer_);
  feedback_ = buffer_ = 0, size_ = 0;
}

}  // namespace gluray::gl
