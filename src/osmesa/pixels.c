#include "osmesa/pixels.h"

#include "intercept/window_systems/osmesa_api.h"
#include "osmesa/opengl_calls.h"

#include <stdlib.h>
#include <string.h>

typedef struct Layout {
  GLenum format, type;
  size_t bytes; /* of a pixel */
} Layout;

static Layout layoutOf(GLenum format) {
  switch (format) {
    case OSMESA_BGRA: return (Layout){GL_BGRA, GL_UNSIGNED_BYTE, 4};
    case OSMESA_ARGB: return (Layout){GL_BGRA, GL_UNSIGNED_INT_8_8_8_8, 4};
    case OSMESA_RGB: return (Layout){GL_RGB, GL_UNSIGNED_BYTE, 3};
    case OSMESA_BGR: return (Layout){GL_BGR, GL_UNSIGNED_BYTE, 3};
    case OSMESA_RGB_565: return (Layout){GL_RGB, GL_UNSIGNED_SHORT_5_6_5, 2};
    default: return (Layout){GL_RGBA, GL_UNSIGNED_BYTE, 4};
  }
}

int osmesaCanHold(GLenum format, GLenum type) {
  switch (format) {
    case OSMESA_RGBA:
    case OSMESA_BGRA:
    case OSMESA_ARGB:
    case OSMESA_RGB:
    case OSMESA_BGR: return type == GL_UNSIGNED_BYTE;
    case OSMESA_RGB_565: return type == GL_UNSIGNED_SHORT_5_6_5;
    default: return 0;
  }
}

/* What a read depends on. Sets it to the defaults until give() gives it back. */
typedef struct Kept {
  GLint framebuffer, buffer, pack, store[6];
  int transfers;
} Kept;

static const GLenum kStores[6] = {GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST,   GL_PACK_ROW_LENGTH,
                                  GL_PACK_SKIP_ROWS,  GL_PACK_SKIP_PIXELS, GL_PACK_ALIGNMENT};

/* Pixel transfer exists in compatibility profiles alone. */
static void plainTransfers(const Calls* gl) {
  static const GLenum kScales[] = {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE,
                                   GL_DEPTH_SCALE};
  static const GLenum kBiases[] = {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS, GL_DEPTH_BIAS};
  gl->PushAttrib(GL_PIXEL_MODE_BIT);
  for (size_t i = 0; i < sizeof kScales / sizeof *kScales; ++i)
    gl->PixelTransferf(kScales[i], 1), gl->PixelTransferf(kBiases[i], 0);
  gl->PixelTransferi(GL_MAP_COLOR, 0);
}

static Kept keep(const Calls* gl) {
  Kept kept;
  GLint profile = 0;
  gl->GetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
  gl->GetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &kept.framebuffer);
  gl->GetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &kept.pack);
  if (kept.framebuffer != 0) gl->BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  gl->GetIntegerv(GL_READ_BUFFER, &kept.buffer);
  if (kept.buffer != GL_FRONT) gl->ReadBuffer(GL_FRONT);
  if (kept.pack != 0) gl->BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  for (int i = 0; i < 6; ++i) {
    gl->GetIntegerv(kStores[i], &kept.store[i]);
    gl->PixelStorei(kStores[i], kStores[i] == GL_PACK_ALIGNMENT ? 1 : 0);
  }
  kept.transfers = !(profile & GL_CONTEXT_CORE_PROFILE_BIT);
  if (kept.transfers) plainTransfers(gl);
  return kept;
}

static void give(const Calls* gl, const Kept* kept) {
  if (kept->transfers) gl->PopAttrib();
  for (int i = 0; i < 6; ++i) gl->PixelStorei(kStores[i], kept->store[i]);
  if (kept->pack != 0) gl->BindBuffer(GL_PIXEL_PACK_BUFFER, (GLuint)kept->pack);
  if (kept->buffer != GL_FRONT) gl->ReadBuffer((GLenum)kept->buffer);
  if (kept->framebuffer != 0) gl->BindFramebuffer(GL_READ_FRAMEBUFFER, (GLuint)kept->framebuffer);
}

static int copy(const Memory* memory, Layout layout) {
  const Calls* const gl = osmesaCalls();
  const size_t row = (size_t)memory->width * layout.bytes, rows = (size_t)memory->height,
               stride = (size_t)(memory->rowLength > 0 ? memory->rowLength : memory->width) * layout.bytes;
  const int straight = memory->yUp && stride == row;
  char* const read = straight ? memory->pixels : malloc(row * rows);
  if (!read) return 0;
  const Kept kept = keep(gl);
  gl->ReadPixels(0, 0, memory->width, memory->height, layout.format, layout.type, read);
  give(gl, &kept);
  if (straight) return 1;
  for (size_t y = 0; y < rows; ++y)
    memcpy((char*)memory->pixels + (memory->yUp ? y : rows - 1 - y) * stride, read + y * row, row);
  free(read);
  return 1;
}

void osmesaCopyColors(const Memory* memory) { copy(memory, layoutOf(memory->format)); }

int osmesaCopyDepths(const Memory* memory, int bytes) {
  const GLenum type = bytes == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
  return copy(memory, (Layout){GL_DEPTH_COMPONENT, type, (size_t)bytes});
}
