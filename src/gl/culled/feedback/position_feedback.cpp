#include "gl/culled/feedback/position_feedback.h"

#include "gl/arrays/assembly.h"
#include "gl/real/feedback_stage.h"
#include "gl/real/state_queries.h"

#include <GL/glext.h>

namespace gluray::gl {
namespace {

constexpr uint64_t kMaxVertexBytes = uint64_t{1} << 30, kMaxInstanceBytes = uint64_t{1} << 28;  // bytes

/// Whether the program itself uses transform feedback, or has rasterisation off.
bool isFeedingBack(const RealGl& real) {
  return integer(real, GL_TRANSFORM_FEEDBACK_ACTIVE) != 0 || isOn(real, GL_RASTERIZER_DISCARD);
}

}  // namespace

bool PositionFeedback::works(const RealGl& real) {
  if (!copy_ && hasFeedbackObjects(real)) copy_.emplace(real, original_);
  return copy_ && copy_->works();
}

bool PositionFeedback::isPossible(uint32_t first, uint32_t end, uint32_t instances) {
  if (end <= first || end > uint32_t{1} << 30) return false;
  const uint64_t most = (instances > 1 ? kMaxInstanceBytes : kMaxVertexBytes) / kStride;
  return uint64_t{end - first} * instances <= most;
}

bool PositionFeedback::draw(const RealGl& real, uint32_t first, uint32_t count, const Elements& as) {
  copy_->copyUniforms(real);
  const WithoutRestart withoutRestart(real);
  const auto bytes = static_cast<GLsizeiptr>(uint64_t{count} * as.repeats() * kStride);
  if (bytes > size_) {
    real.BindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, buffer_);
    real.BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, bytes, nullptr, GL_STREAM_READ);
    size_ = bytes;
  }
  real.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer_);
  real.BeginTransformFeedback(GL_POINTS);
  drawReal(
      real, GL_POINTS,
      {static_cast<GLint>(first), static_cast<GLsizei>(count), 0, nullptr, 0, as.instances, as.baseInstance});
  real.EndTransformFeedback();
  return real.GetError() == GL_NO_ERROR;
}

bool PositionFeedback::capture(const RealGl& real, uint32_t first, uint32_t end, const Elements& as,
                               const std::function<void(const std::byte*)>& take) {
  if (!isPossible(first, end, as.repeats()) || !works(real) || isFeedingBack(real)) return false;
  if (feedback_ == 0) real.GenTransformFeedbacks(1, &feedback_), real.GenBuffers(1, &buffer_);
  const FeedbackStage stage(real, copy_->name(), feedback_);
  if (draw(real, first, end - first, as)) {
    const auto bytes = static_cast<GLsizeiptr>(uint64_t{end - first} * as.repeats() * kStride);
    const MappedFeedback mapped(real, bytes);
    if (mapped.data()) return take(static_cast<const std::byte*>(mapped.data())), true;
  }
  size_ = 0;
  while (real.GetError() != GL_NO_ERROR) {}
  return false;
}

void PositionFeedback::release(const RealGl& real) {
  if (copy_) copy_->release(real);
  if (feedback_ != 0) real.DeleteTransformFeedbacks(1, &feedback_), real.DeleteBuffers(1, &buffer_);
  feedback_ = buffer_ = 0, size_ = 0;
}

}  // namespace gluray::gl
