#include "intercept/frames/kept_buffer.h"

#include "intercept/present/read_back/window_buffers.h"
#include "intercept/session/guarded.h"

#include <utility>

namespace gluray::intercept {

using control::KeptImage;

void keepBuffer(Record& record, GLenum buffer, ShownFrame shown) noexcept {
  if (!isImageWanted(shown)) return;
  guarded("cannot keep an image", [&] {
    gl::Context* const context = record.context.get();
    if (!context || record.version.starts_with("OpenGL ES") || context->lists.compiling() ||
        context->immediate.insideBegin())
      return;
    const glm::ivec2 size = current().size ? current().size() : glm::ivec2(0);
    if (size.x <= 0 || size.y <= 0) return;
    if (!record.features) record.features = present::readFeatures(context->real);
    auto image = newWindowImage(size, KeptImage::Layout::openGl, shown);
    bool read = false;
    const GLenum pending =
        present::readColors(context->real, *record.features, size, buffer, image->pixels, read);
    if (pending != GL_NO_ERROR) context->errors.set(pending);
    if (read) keepWindowImage(std::move(image));
  });
}

}  // namespace gluray::intercept
