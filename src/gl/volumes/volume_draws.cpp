#include "gl/volumes/volume_draws.h"

#include "gl/batch/presenter.h"
#include "gl/pending/pending_batch.h"
#include "gl/real/state_queries.h"
#include "gl/shadow/shadow_state.h"
#include "gl/state/output_state.h"
#include "gl/volumes/volume_reader.h"
#include "scene/effects.h"
#include "scene/secondary_scene.h"

#include <GL/glext.h>
#include <glm/gtc/matrix_transform.hpp>

#include <utility>
#include <vector>

namespace gluray::gl {
namespace {

/// Whether blended colours go over the framebuffer's, premultiplied by their alpha.
bool blendsOver(const RealGl& real) {
  const auto is = [&](GLenum name, GLint value) { return integer(real, name) == value; };
  return is(GL_BLEND_EQUATION_RGB, GL_FUNC_ADD) && is(GL_BLEND_EQUATION_ALPHA, GL_FUNC_ADD) &&
         is(GL_BLEND_SRC_RGB, GL_ONE) && is(GL_BLEND_DST_RGB, GL_ONE_MINUS_SRC_ALPHA) &&
         is(GL_BLEND_SRC_ALPHA, GL_ONE) && is(GL_BLEND_DST_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
}

/// The pixels that points of data space in front of the viewer may cover; all of them if one is behind.
scene::Region regionOf(const scene::VolumeView& view, const scene::Region& pixels) {
  const glm::dvec2 least(pixels.x, pixels.y), most(pixels.x + pixels.width, pixels.y + pixels.height);
  glm::dvec2 lower = most, upper = least;
  for (const glm::dvec3& corner : view.faces) {
    const glm::dvec4 p = view.windowFromData * glm::dvec4(corner, 1);
    if (!(p.w > 0)) return pixels;
    lower = glm::min(lower, glm::dvec2(p) / p.w), upper = glm::max(upper, glm::dvec2(p) / p.w);
  }
  const glm::ivec2 first(glm::floor(glm::clamp(lower, least, most))),
      end(glm::ceil(glm::clamp(upper, least, most)));
  return {first.x, first.y, end.x - first.x, end.y - first.y};
}

bool isFront(const glm::dmat4& windowFromData, const glm::dvec3* corners, bool counterClockwise) {
  glm::dmat3 m;
  for (int c = 0; c < 3; ++c) {
    const glm::dvec4 p = windowFromData * glm::dvec4(corners[c], 1);
    m[c] = {p.x, p.y, p.w};
  }
  return (glm::determinant(m) > 0) == counterClockwise;
}

/// Whether each face lies in one of the box from -0.5 to size - 0.5: then rays have steps to one of them
/// alone.
bool areFacesOfBox(const scene::VolumeView& view) {
  for (size_t i = 0; i + 2 < view.faces.size(); i += 3) {
    bool inPlane = false;
    for (int axis = 0; axis < 3; ++axis)
      for (const double end : {-0.5, view.span->size[axis] - 0.5}) {
        const auto at = [&](size_t c) { return view.faces[i + c][axis] == end; };
        inPlane = inPlane || (at(0) && at(1) && at(2));
      }
    if (!inPlane) return false;
  }
  return true;
}

}  // namespace

/// `spanned`: its colours and depths are written as the program has set it, in place of being blended over
/// the framebuffer.
const char* VolumeDraws::obstacleToBlending(bool spanned) const {
  const RealGl& real = p_.shadow.real;
  const TargetState& target = p_.shadow.target();
  const RasterState& raster = p_.shadow.raster();
  const bool samples = target.samples > 1 && raster.multisample;
  if (spanned) {
    if (samples) return "its framebuffer has several samples";
    return raster.cull == scene::CullFace::both ? "its faces are culled" : nullptr;
  }
  if (isOn(real, GL_BLEND) && !blendsOver(real)) return "it is not blended over the framebuffer";
  if (!isOn(real, GL_BLEND) && samples) return "it replaces the colours of samples";
  if (isOn(real, GL_DEPTH_TEST) && integer(real, GL_DEPTH_WRITEMASK)) return "it writes depth";
  if (raster.cull == scene::CullFace::none || raster.cull == scene::CullFace::both)
    return "its faces are not culled";
  return nullptr;
}

bool VolumeDraws::hasOffset() const {
  const RasterState& raster = p_.shadow.raster();
  return raster.offsetFill && (raster.offsetFactor != 0 || raster.offsetUnits != 0);
}

const char* VolumeDraws::obstacle() const {
  const RealGl& real = p_.shadow.real;
  const TargetState& target = p_.shadow.target();
  const RasterState& raster = p_.shadow.raster();
  if (p_.failsafe.aside()) return "GLuRay has stepped aside";
  if (p_.shadow.activeQueries > 0) return "a query counts it";
  if (target.reason != Reason::traced && target.reason != Reason::noDepthBuffer)
    return "its framebuffer is not traced";
  if (hasMoreDrawBuffers(real)) return "it has several draw buffers";
  const bool spanned = p_.shadow.program().known->family->volume.span.given();
  if (const char* found = obstacleToBlending(spanned)) return found;
  if (isOn(real, GL_DEPTH_TEST) && raster.depthFunc != GL_LESS && raster.depthFunc != GL_LEQUAL)
    return "it has another depth test";
  if (isOn(real, GL_STENCIL_TEST) || isOn(real, GL_COLOR_LOGIC_OP))
    return "it has a stencil test or a logic operation";
  if (hasOffset() && !spanned) return "its faces have a polygon offset";
  GLboolean channels[4] = {GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE};
  real.GetBooleanv(GL_COLOR_WRITEMASK, channels);
  if (!(channels[0] && channels[1] && channels[2] && channels[3])) return "it does not write all channels";
  GLint polygons[2] = {GL_FILL, GL_FILL};
  real.GetIntegerv(GL_POLYGON_MODE, polygons);
  if (polygons[0] != GL_FILL) return "its faces are not filled";
  const ViewportState& viewport = p_.shadow.viewport();
  if (viewport.depthNear != 0 || viewport.depthFar != 1) return "its depth range is not 0 to 1";
  return rareReason(real, p_.shadow.rare()) == Reason::traced ? nullptr : "rarely used state prevents it";
}

bool VolumeDraws::readFaces(GLenum mode, const Elements& elements, scene::VolumeView& view) const {
  const ArrayState& arrays = p_.shadow.attributes();
  const bool strip = mode == GL_TRIANGLE_STRIP && view.span.has_value();
  if ((mode != GL_TRIANGLES && !strip) || elements.instances > 1 || !arrays.vertex.enabled) return false;
  const std::vector<uint32_t> numbers = vertexNumbers(p_.shadow.real, arrays, elements);
  if (numbers.size() > 3 * kMostVolumeFaces || numbers.size() != static_cast<size_t>(elements.count))
    return false;
  const ArrayReader reader(p_.shadow.real, arrays.vertex);
  std::vector<glm::dvec3> corners;
  for (const uint32_t number : numbers) {
    if (number >= reader.available()) return false;
    float p[4];
    reader.read(number, p);
    if (p[3] != 1) return false;
    corners.emplace_back(p[0], p[1], p[2]);
  }
  const RasterState& raster = p_.shadow.raster();
  for (size_t i = 0; i + 2 < corners.size(); i += strip ? 1 : 3) {
    // In strips, every second triangle is turned.
    const bool front =
        isFront(view.windowFromData, &corners[i], raster.frontFaceCcw) != (strip && i % 2 == 1);
    if (raster.cull == scene::CullFace::none || front == (raster.cull == scene::CullFace::back))
      view.faces.insert(view.faces.end(), {corners[i], corners[i + 1], corners[i + 2]});
  }
  return !view.span || areFacesOfBox(view);
}

bool VolumeDraws::read(GLenum mode, const Elements& elements, scene::VolumeCast& cast, Place& place,
                       std::string& why) {
  if (const char* found = obstacle()) return why = found, false;
  VolumeReader reader(p_.shadow, maps_);
  if (!reader.read(cast)) return why = reader.why(), false;
  // Depths that shaders write have no offset.
  if (hasOffset() && cast.view.span && !cast.view.span->showsDepth)
    return why = "its faces have a polygon offset", false;
  const glm::ivec4& box = p_.shadow.viewport().box;
  const glm::dmat4 windowFromClip =
      glm::translate(glm::dmat4(1), {box.x + 0.5 * box.z, box.y + 0.5 * box.w, 0.5}) *
      glm::scale(glm::dmat4(1), {0.5 * box.z, 0.5 * box.w, 0.5});
  place = {reader.clipFromData(), reader.eyeFromData()};
  cast.view.windowFromData = windowFromClip * place.clipFromData;
  if (!readFaces(mode, elements, cast.view))
    return why = "its faces are no triangles that can be read", false;
  scene::Region pixels = Batch::keyOf(p_.shadow.pixelState(), glm::dmat4(1)).region;
  p_.filler.clampToTarget(pixels);
  cast.view.region = regionOf(cast.view, pixels);
  cast.view.replaces = !isOn(p_.shadow.real, GL_BLEND);
  using Test = scene::VolumeView::DepthTest;
  if (isOn(p_.shadow.real, GL_DEPTH_TEST) && p_.shadow.target().reason == Reason::traced)
    cast.view.depthTest = p_.shadow.raster().depthFunc == GL_LESS ? Test::less : Test::lessOrEqual;
  if (const TargetState& target = p_.shadow.target(); target.samples > 1 && p_.shadow.raster().multisample)
    cast.view.samplePositions = target.samplePositions;
  const scene::Region& region = cast.view.region;
  if (region.width <= 0 || region.height <= 0 || cast.view.faces.empty()) return cast.view.region = {}, true;
  return reader.readDepths(cast.view) || (why = reader.why(), false);
}

void VolumeDraws::placeInView(const Place& place, scene::VolumeCast& cast) {
  const Settings& settings = p_.shadow.settings;
  if (!scene::changesLight(settings) || !p_.pending.presenter.lightsVolumes()) return;
  if (cast.volume.blend != scene::VolumeBlend::composite || cast.view.slice) return;
  viewKey_ = Batch::keyOf(p_.shadow.pixelState(), place.clipFromData * glm::inverse(place.eyeFromData));
  viewKey_.region = cast.view.region;
  view_.start(viewKey_, p_.shadow.target(), place.eyeFromData, settings, p_.clock.frame);
  scene::Snapshot& s = view_.unnumbered();
  s.samples = 1, s.samplePositions = {glm::vec2(0.5f)};
  auto medium = std::make_shared<scene::Medium>();
  medium->volume = cast.volume;
  medium->textureFromData = cast.view.textureFromData;
  medium->step = cast.view.step;
  medium->lower = cast.view.lower, medium->upper = cast.view.upper;
  medium->clipping = cast.view.clipping;
  view_.add({std::move(medium), place.eyeFromData});
  ViewScenes& views = p_.surfaces.views;
  if (views.isLeftAlone(viewKey_, s)) return void(view_.takeSnapshot());
  view_.setUpwardAxis(views.upwardAxisOf(viewKey_, s));
  const bool isLast = p_.clock.shows && viewKey_.framebuffer == 0 && p_.shadow.info.doubleBuffered;
  view_.setSecondaryScene(views.secondaryScene(viewKey_, s, isLast));
  cast.lit = view_.takeSnapshot();
}

bool VolumeDraws::castInView(const scene::VolumeCast& cast, std::string& why) {
  const bool blocks = cast.lit && scene::needsSecondaryScene(cast.lit->settings);
  if (blocks) {
    p_.surfaces.views.traced(viewKey_, cast.lit);
    p_.relighting.update(viewKey_.framebuffer);
  }
  const bool drawn = p_.pending.presenter.castVolume(p_.shadow.real, cast, why);
  if (!drawn && blocks) p_.surfaces.views.withdraw(cast.lit);
  return drawn;
}

bool VolumeDraws::draw(GLenum mode, const Elements& elements) {
  scene::VolumeCast cast;
  Place place;
  std::string why;
  p_.shadow.errors.keepPending();
  bool drawn = read(mode, elements, cast, place, why);
  // Of our queries: what presents images keeps errors as the program's.
  p_.shadow.errors.takeReal();
  if (drawn && cast.view.region.width > 0) {
    p_.raster.before(PrimitiveClass::surfaces);
    placeInView(place, cast);
    drawn = castInView(cast, why);
    p_.shadow.errors.takeReal();
  }
  if (!drawn) p_.shadow.setProgramWhy(std::move(why));
  return drawn;
}

}  // namespace gluray::gl
