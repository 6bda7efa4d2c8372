#include "intercept/present/write_back/write_back.h"

#include "base/timeline.h"
#include "intercept/present/state/texture_growth.h"
#include "intercept/present/state/texture_names.h"
#include "intercept/present/write_back/write_back_program.h"

#include <algorithm>
#include <utility>

namespace gluray::present {

namespace {

constexpr scene::ColorWrites kNoColors{false, false, false, false};

WriteBackSource sourceOf(WriteBack::Colors colors) {
  if (colors == WriteBack::Colors::taken) return WriteBackSource::taken;
  return colors == WriteBack::Colors::sums ? WriteBackSource::sums : WriteBackSource::colors;
}

}  // namespace

bool WriteBack::ready(std::string& why) {
  if (state_ == State::unknown) {
    features_ = readFeatures(real_);
    state_ = compile(why_) ? State::ready : State::impossible;
  }
  why = why_;
  return state_ == State::ready;
}

bool WriteBack::compile(std::string& why) {
  if (features_.glslVersion < 110) return why = "the real OpenGL has no GLSL", false;
  if (features_.redFloatTextures) {
    depthInternalFormat_ = GL_R32F, depthFormat_ = GL_RED;
  } else if (features_.floatTextures) {
    depthInternalFormat_ = GL_LUMINANCE32F_ARB, depthFormat_ = GL_LUMINANCE;
  } else {
    return why = "the real OpenGL has no float textures", false;
  }
  for (Program& program : programs_)
    if (!compile(program, why)) return false;
  if (!features_.compatibility) real_.GenVertexArrays(1, &vertexArray_);
  return true;
}

bool WriteBack::compile(Program& program, std::string& why) const {
  program.name = buildWriteBackProgram(real_, features_, sourceOf(colors_), why);
  if (!program.name) return false;
  StateGuard guard(real_, features_);
  guard.program(program.name);
  program.place = real_.GetUniformLocation(program.name, "place");
  program.bands = real_.GetUniformLocation(program.name, "bands");
  real_.Uniform1i(real_.GetUniformLocation(program.name, "colorPlane"), features_.textureUnit);
  real_.Uniform1i(real_.GetUniformLocation(program.name, "depthPlane"), features_.textureUnit + 1);
  return true;
}

bool WriteBack::makePlane(StateGuard& guard, int unit, PlaneTexture& plane, GLenum internalFormat,
                          GLenum format, GLenum type, int width, int height) {
  const bool fresh = plane.texture == 0;
  if (fresh) {
    const std::lock_guard lock(textureNaming());
    plane.texture = newTextureName(real_, features_);
    guard.texture2D(unit, plane.texture);
  } else {
    guard.texture2D(unit, plane.texture);
  }
  if (fresh) {
    for (GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
      real_.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    for (GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
      real_.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  }
  const glm::ivec2 size = grownSize(plane.size, {width, height});
  if (size == plane.size) return true;
  real_.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internalFormat), size.x, size.y, 0, format, type,
                   nullptr);
  if (real_.GetError() != GL_NO_ERROR) {
    color_.size = depth_.size = {};  // both have one size
    return false;
  }
  plane.size = size;
  return true;
}

namespace {

/// Source pointers for uploads into the textures of colours and depths.
const void* colorsFrom(const Image& image, size_t pixel) {
  return image.has(Plane::color) ? static_cast<const void*>(&image.color[pixel])
                                 : &image.wideColor[4 * pixel];
}

const void* secondFrom(const Image& image, size_t pixel, bool centers) {
  if (centers) return &image.centerDepth[pixel];
  return image.has(Plane::transmittance) ? &image.transmittance[pixel] : &image.depth[pixel];
}

}  // namespace

void WriteBack::upload(const Image& image, const Sheet& sheet, Part part) const {
  const int unit = features_.textureUnit;
  const auto width = static_cast<size_t>(image.width);
  const size_t plane = width * static_cast<size_t>(image.height) * static_cast<size_t>(sheet.sample);
  for (const bool color : {false, true}) {
    if (color && part == Part::depths) continue;
    real_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(color ? unit : unit + 1));
    for (const frame::Band& band : sheet.bands) {
      const size_t first = plane + static_cast<size_t>(band.y) * width + static_cast<size_t>(band.x);
      const bool bytes = color && colors_ == Colors::bytes;
      real_.TexSubImage2D(GL_TEXTURE_2D, 0, band.x, band.y + sheet.row, band.width, band.height,
                          color ? GL_RGBA : depthFormat_, bytes ? GL_UNSIGNED_BYTE : GL_FLOAT,
                          color ? colorsFrom(image, first)
                                : secondFrom(image, first, part == Part::depths && image.isAverages()));
    }
  }
}

void WriteBack::draw(glm::ivec2 at, int width, int height, const Sheet& sheet) const {
  real_.Uniform4f(programs_[0].place, static_cast<GLfloat>(at.x), static_cast<GLfloat>(at.y - sheet.row),
                  1.0f / static_cast<GLfloat>(color_.size.x), 1.0f / static_cast<GLfloat>(color_.size.y));
  GLfloat corners[frame::kMaxBands][4];  // left, lower, right, upper in clip space
  const auto clip = [](int at, int size) {
    return 2.0f * static_cast<float>(at) / static_cast<float>(size) - 1.0f;
  };
  int count = 0;
  for (const frame::Band& b : sheet.bands) {
    GLfloat* c = corners[count++];
    c[0] = clip(b.x, width), c[1] = clip(b.y, height);
    c[2] = clip(b.x + b.width, width), c[3] = clip(b.y + b.height, height);
  }
  if (!features_.compatibility) {
    real_.Uniform4fv(programs_[0].bands, count, corners[0]);
    real_.DrawArrays(GL_TRIANGLES, 0, 6 * count);
    return;
  }
  // glVertex changes no current value and needs no array state.
  real_.Begin(GL_QUADS);
  for (int i = 0; i < count; ++i) {
    const GLfloat* c = corners[i];
    real_.Vertex2f(c[0], c[1]);
    real_.Vertex2f(c[2], c[1]);
    real_.Vertex2f(c[2], c[3]);
    real_.Vertex2f(c[0], c[3]);
  }
  real_.End();
}

void WriteBack::openFor(StateGuard& guard, const WriteBackTarget& target) const {
  const auto isOn = [&](GLenum what) {
    GLboolean on = GL_FALSE;
    real_.GetBooleanv(what, &on);
    return on == GL_TRUE;
  };
  const bool blends = target.asProgram && isOn(GL_BLEND),
             writesDepth = !target.asProgram || isOn(GL_DEPTH_WRITEMASK);
  guard.openFragmentPath();
  if (blends) guard.capability(GL_BLEND, true);
  guard.depthRange(0, 1);
  if (target.encodes) guard.encoding(*target.encodes);
  guard.colorWrites(target.colors ? target.colorWrites : kNoColors);
  const bool sums = colors_ == Colors::sums;
  if (!sums && !target.over && target.depths) {
    guard.depthTest(target.depthFunc);
    return guard.depthWrites(writesDepth);
  }
  if (sums) guard.addUp();
  guard.capability(GL_DEPTH_TEST, false);
}

void WriteBack::writeAverages(StateGuard& guard, const Image& image, const Sheet& sheet,
                              const WriteBackTarget& target) const {
  upload(image, sheet, Part::colors);
  {
    StateGuard over(real_, features_);
    over.depthWrites(false);
    if (!target.replaces) over.blendOver();
    draw(image, sheet);
  }
  if (target.keepsDepth) return;
  upload(image, sheet, Part::depths);
  guard.colorWrites(kNoColors);
  draw(image, sheet);
}

void WriteBack::findSheets(const Image& image, int planes) {
  sheets_.clear();
  const size_t pixels = static_cast<size_t>(image.width) * static_cast<size_t>(image.height);
  for (int s = 0; s < image.samples; ++s) {
    Sheet sheet{
        s, s % planes * image.height,
        frame::hitBands(image.depth.data() + pixels * static_cast<size_t>(s), image.width, image.height)};
    if (!sheet.bands.empty()) sheets_.push_back(std::move(sheet));
  }
}

bool WriteBack::write(const Image& image, const WriteBackTarget& target, PendingErrors& pending) {
  const timeline::Span span("write back");
  std::string why;
  pending = takeErrors(real_);
  if (colorsOf(image) != colors_ || !ready(why)) return false;
  const int width = image.width, height = image.height, limit = features_.maxTextureSize;
  if (width <= 0 || height <= 0 || image.samples <= 0) return true;
  if (width > limit || height > limit) return false;
  if (image.samples > 1 && (!features_.sampleMask || image.samples > 32)) return false;

  // One texture holds as many sample planes as fit, one above the other.
  const int planes = std::min(image.samples, limit / height);
  if (target.imageId == 0 || target.imageId != held_) {
    held_ = 0;
    findSheets(image, planes);
  }
  if (sheets_.empty()) return true;
  StateGuard guard(real_, features_);
  if (!writeInto(guard, image, target, planes) || real_.GetError() != GL_NO_ERROR) return held_ = 0, false;
  const bool all = !image.isAverages() && planes == image.samples && target.colors;
  held_ = all ? target.imageId : 0;
  return true;
}

void WriteBack::useProgram(StateGuard& guard) {
  std::swap(programs_[0], programs_[1]);
  guard.program(programs_[0].name);
  if (!features_.compatibility) guard.vertexArray(vertexArray_);
}

bool WriteBack::writeInto(StateGuard& guard, const Image& image, const WriteBackTarget& target, int planes) {
  const int width = image.width, height = image.height, unit = features_.textureUnit;
  guard.plainUnpack(width);
  if (!makePlane(guard, unit + 1, depth_, depthInternalFormat_, depthFormat_, GL_FLOAT, width,
                 height * planes) ||
      !makePlane(guard, unit, color_, colors_ == Colors::bytes ? GL_RGBA8 : GL_RGBA32F_ARB, GL_RGBA,
                 GL_UNSIGNED_BYTE, width, height * planes))
    return false;
  if (target.over) guard.drawToWindow(target.over);
  openFor(guard, target);
  guard.viewport(image.x, image.y, width, height);
  guard.scissor(image.x, image.y, width, height);
  useProgram(guard);
  if ((image.isAverages() || target.keepsDepth) && colors_ != Colors::sums) {
    writeAverages(guard, image, sheets_.front(), target);
    return true;
  }
  // First all uploads of a full texture: an upload after a draw would wait for that draw.
  for (size_t first = 0; first < sheets_.size();) {
    size_t end = first;
    for (; end < sheets_.size() && sheets_[end].sample / planes == sheets_[first].sample / planes; ++end)
      if (held_ == 0) upload(image, sheets_[end], target.colors ? Part::all : Part::depths);
    for (; first < end; ++first) {
      if (image.samples > 1) guard.onlySample(sheets_[first].sample);
      draw(image, sheets_[first]);
    }
  }
  return true;
}

gl::SharedNames WriteBack::takeNames() {
  gl::SharedNames names;
  names.textures = {color_.texture, depth_.texture};  // deleting name 0 does nothing
  for (const Program& program : programs_) names.programs.push_back(program.name);
  color_ = depth_ = {};
  held_ = 0;
  programs_ = {};
  state_ = State::unknown;
  return names;
}

void WriteBack::release() {
  if (color_.texture) real_.DeleteTextures(1, &color_.texture);
  if (depth_.texture) real_.DeleteTextures(1, &depth_.texture);
  for (const Program& program : programs_)
    if (program.name) real_.DeleteProgram(program.name);
  if (vertexArray_) real_.DeleteVertexArrays(1, &vertexArray_);
  color_ = depth_ = {};
  held_ = 0;
  programs_ = {};
  vertexArray_ = 0;
  state_ = State::unknown;
}

}  // namespace gluray::present
