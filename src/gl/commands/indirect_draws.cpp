// Handlers of draws whose parameters are in a buffer object. Large draws by shader programs are culled like
// the direct draws that the parameters describe. The real OpenGL makes all others.
#include "gl/commands/array_draws.h"
#include "gl/commands/bound_buffer.h"
#include "gl/context/handlers.h"
#include "gl/context/stub.h"
#include "gl/counts/draw_kinds.h"
#include "gl/real/extensions.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <iterator>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

namespace gluray::gl {
namespace {

struct IndirectDraws {
  GLenum mode = 0;
  GLenum type = 0;  // of the indices; 0: none
  const void* indirect = nullptr;
  GLsizei draws = 1, stride = 0;
  bool several = false;  // a multi-draw command, whatever `draws` is

  size_t size() const { return (type ? 5 : 4) * sizeof(GLuint); }
  size_t step() const { return stride > 0 ? static_cast<size_t>(stride) : size(); }
  /// The draws with numbers [first, end).
  IndirectDraws part(GLsizei first, GLsizei end) const {
    IndirectDraws some = *this;
    if (first == 0 && end == draws) return some;
    some.indirect = static_cast<const std::byte*>(indirect) + static_cast<size_t>(first) * step();
    some.draws = end - first;
    return some;
  }
};

void drawBelow(const RealGl& real, const IndirectDraws& d) {
  if (d.several && d.type)
    return real.MultiDrawElementsIndirect(d.mode, d.type, d.indirect, d.draws, d.stride);
  if (d.several) return real.MultiDrawArraysIndirect(d.mode, d.indirect, d.draws, d.stride);
  if (d.type) return real.DrawElementsIndirect(d.mode, d.type, d.indirect);
  real.DrawArraysIndirect(d.mode, d.indirect);
}

int commandNamed(std::string_view name) {
  const auto* const row =
      std::ranges::find(kCommandNames, name, [](const auto& r) { return std::string_view(r.name); });
  return static_cast<int>(row - std::begin(kCommandNames));
}

/// Makes the draws as commands that are not modelled.
void leave(Context& c, const IndirectDraws& d) {
  static const std::array kCommands{
      commandNamed("glDrawArraysIndirect"), commandNamed("glDrawElementsIndirect"),
      commandNamed("glMultiDrawArraysIndirect"), commandNamed("glMultiDrawElementsIndirect")};
  c.count(kCommands[(d.several ? 2u : 0u) + (d.type ? 1u : 0u)]);
  c.beforeForward(Context::Flush::all);
  c.touch(kAllGroups);
  drawBelow(c.real, d);
}

/// 0 means no indices, and is the same error as any other wrong type.
GLenum indexType(GLenum type) { return type ? type : GL_FLOAT; }

/// Whether the real OpenGL has the command, without extensions that change its errors.
bool exists(const RealGl& real, const IndirectDraws& d) {
  const int version = versionOf(real);
  if (version >= 43) return true;
  return hasExtension(real, version, "GL_ARB_draw_indirect") &&
         (!d.several || hasExtension(real, version, "GL_ARB_multi_draw_indirect"));
}

/// Whether everything that the draws read is in known buffers, so that they raise no error for this.
bool readsBuffers(const ArrayState& arrays, const IndirectDraws& d) {
  bool buffers = !d.type || arrays.elements;
  const auto look = [&](const ArraySource& a) { buffers = buffers && (!a.enabled || a.buffer); };
  arrays.forEach(look);
  for (const ArraySource& a : arrays.generic) look(a);
  return buffers && arrays.reason != Reason::deletedBuffer && foreignReason(arrays) == Reason::traced;
}

/// The draw that a command describes; an empty one if its numbers are too large.
Elements elementsOf(const std::byte* command, GLenum type) {
  std::array<GLuint, 5> words{};
  std::memcpy(words.data(), command, (type ? 5 : 4) * sizeof(GLuint));
  constexpr GLuint kMax = std::numeric_limits<GLsizei>::max();
  Elements e;
  e.instances = 0;
  if (words[0] > kMax || words[1] > kMax || words[2] > kMax) return e;
  e.count = static_cast<GLsizei>(words[0]), e.instances = static_cast<GLsizei>(words[1]);
  e.baseInstance = words[type ? 4 : 3];
  if (!type) {
    e.first = static_cast<GLint>(words[2]);
    return e;
  }
  e.type = type, e.base = static_cast<GLint>(words[3]);
  e.indices = reinterpret_cast<const void*>(size_t{words[2]} * sizeOfType(type));
  return e;
}

/// The draws that the commands describe; empty if they are unknown, or the real OpenGL raises an error.
std::vector<Elements> readCommands(Context& c, const IndirectDraws& d) {
  constexpr GLsizei kMax = 1 << 16;
  const auto at = reinterpret_cast<uintptr_t>(d.indirect);
  if (d.draws < 1 || d.draws > kMax || d.stride < 0 || d.stride % 4 != 0 || at % 4 != 0) return {};
  if (d.mode > GL_POLYGON || (d.type && !isIndexType(d.type)) || !exists(c.real, d)) return {};
  const std::shared_ptr<Buffer> buffer = bound(c, GL_DRAW_INDIRECT_BUFFER);
  if (!buffer || buffer->foreign || buffer->mapped() || buffer->mappedBelow) return {};
  const std::shared_ptr<const BufferStorage> storage = buffer->read(c.real);
  const size_t bytes = static_cast<size_t>(d.draws - 1) * d.step() + d.size();
  if (!storage || at > storage->size || storage->size - at < bytes) return {};
  std::vector<Elements> all;
  for (GLsizei i = 0; i < d.draws; ++i)
    all.push_back(elementsOf(storage->data + at + static_cast<size_t>(i) * d.step(), d.type));
  return all;
}

/// The draws; nullopt if their arrays are not in buffers.
std::optional<std::vector<Elements>> describe(Context& c, const IndirectDraws& d) {
  c.shadow.refresh(kProgramGroups);
  if (!readsBuffers(c.shadow.attributes(), d)) return std::nullopt;
  return readCommands(c, d);
}

/// Whether the draws may be passes over surfaces that are traced (docs/adr/0009).
bool mayMeetPasses(Context& c) {
  if (c.clock.passesThrough()) return false;
  return c.protect([&] { return c.surfaces.passes.any() || !c.untraced.areAll(); });
}

void meetPasses(Context& c, GLenum mode, const std::vector<Elements>& all) {
  if (c.shadow.raster().program == 0) return;
  c.protect([&] {
    for (const Elements& e : all)
      if (e.count > 0 && e.instances > 0) c.programs.meetPasses(kindOf(mode), mode, e);
  });
}

/// Whether one of the draws is large enough to be culled.
bool isCulled(Context& c, const std::vector<Elements>& all) {
  if (all.empty()) c.counts.notCulled(CullReason::indirect);
  return std::ranges::any_of(all, [&](const Elements& e) { return c.culled.isLarge(e); });
}

/// Draws that are not culled are passed on together.
void drawAll(Context& c, const IndirectDraws& d, const std::vector<Elements>& all) {
  const PrimitiveClass kind = kindOf(d.mode);
  GLsizei drawn = 0;
  uint64_t small = 0;
  const auto prepare = [&] { c.raster.before(kind), c.shadow.sendBuffers(); };
  const auto drawUpTo = [&](GLsizei end) {
    if (drawn < end) drawBelow(c.real, d.part(drawn, end)), prepare();
    drawn = end;
  };
  prepare();
  for (GLsizei i = 0; i < d.draws; ++i) {
    const Elements& e = all[static_cast<size_t>(i)];
    const uint64_t triangles = trianglesOf(d.mode, e);
    if (!c.culled.isLarge(e)) {
      small += triangles;
      continue;
    }
    c.counts.rasterised(Reason::program, pathOf(e), kind, triangles);
    if (!c.culled.draw(d.mode, e, [&] { drawUpTo(i); })) continue;
    drawn = i + 1;
    prepare();
  }
  if (drawn < d.draws) drawBelow(c.real, d.part(drawn, d.draws));
  if (small > 0) c.counts.rasterised(Reason::program, pathOf(all[0]), kind, small);
}

void draw(Context& c, const IndirectDraws& d) {
  if (c.lists.compiling()) return c.lists.recordFragment([&] { drawBelow(c.real, d); });
  const bool meets = mayMeetPasses(c), culls = c.culled.takesParts();
  const auto known = meets || culls ? describe(c, d) : std::nullopt;
  if (meets && known) meetPasses(c, d.mode, *known);
  if (!culls || !known || !isCulled(c, *known)) return leave(c, d);
  const std::vector<Elements>& all = *known;
  const DrawTimer timer(c.counts.kinds());
  if (c.clock.passesThrough()) {
    uint64_t triangles = 0;
    for (const Elements& e : all) triangles += trianglesOf(d.mode, e);
    if (c.passthrough.takes(pathOf(all[0]), kindOf(d.mode), triangles)) return drawBelow(c.real, d);
    c.shadow.refresh(kProgramGroups);
  }
  c.passthrough.works();
  drawAll(c, d, all);
}

}  // namespace

void drawArraysIndirect(Context& c, GLenum mode, const void* indirect) { draw(c, {mode, 0, indirect}); }

void drawElementsIndirect(Context& c, GLenum mode, GLenum type, const void* indirect) {
  draw(c, {mode, indexType(type), indirect});
}

void multiDrawArraysIndirect(Context& c, GLenum mode, const void* indirect, GLsizei draws, GLsizei stride) {
  draw(c, {mode, 0, indirect, draws, stride, true});
}

void multiDrawElementsIndirect(Context& c, GLenum mode, GLenum type, const void* indirect, GLsizei draws,
                               GLsizei stride) {
  draw(c, {mode, indexType(type), indirect, draws, stride, true});
}

}  // namespace gluray::gl
