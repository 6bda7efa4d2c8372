#include "tests/fuzz/scenes/scene.h"

#include "tests/fuzz/scenes/dice.h"
#include "tests/fuzz/scenes/shape.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <array>

namespace gluray::fuzz {
namespace {

class Scene {
 public:
  Scene(const gl::RealGl& gl, uint64_t seed, std::vector<float>& answers)
      : gl_(gl), dice_(seed), answers_(answers) {}
  void draw();

 private:
  void camera();
  void texture(GLuint name);
  void lights();
  void material(GLenum face);
  void surfaceState();
  void fragmentState();
  void object();
  void mark();
  void ask();
  void toggle(GLenum capability, uint32_t percent) {
    dice_.chance(percent) ? gl_.Enable(capability) : gl_.Disable(capability);
  }

  const gl::RealGl& gl_;
  Dice dice_;
  std::vector<float>& answers_;
  GLuint lists_ = 0;
};

void Scene::draw() {
  gl_.Enable(GL_DEPTH_TEST);
  const auto background = dice_.color();
  gl_.ClearColor(background[0], background[1], background[2], 1);
  gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  gl_.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 8);  // 0: avoided.md
  for (GLuint name = 1; name < 3; ++name) texture(name);
  camera(), lights();
  const uint32_t objects = 2 + dice_.below(6);
  for (uint32_t i = 0; i < objects; ++i) {
    if (dice_.chance(60)) surfaceState();
    if (dice_.chance(40)) fragmentState();
    if (dice_.chance(20)) lights();
    const bool saves = dice_.chance(20);
    if (saves)
      gl_.PushAttrib(dice_.pick({GL_ALL_ATTRIB_BITS, GL_CURRENT_BIT, GL_LIGHTING_BIT, GL_ENABLE_BIT}));
    object();
    if (dice_.chance(20)) mark();
    if (dice_.chance(30)) ask();
    // Mesa leaves attributes current that were set right before, unless they are queried (avoided.md).
    GLfloat asked[4];
    if (saves) gl_.GetFloatv(GL_CURRENT_COLOR, asked), gl_.PopAttrib();
    if (dice_.chance(10)) camera();
  }
  ask();
}

void Scene::camera() {
  gl_.Viewport(0, 0, kSceneSize, kSceneSize);
  gl_.MatrixMode(GL_PROJECTION), gl_.LoadIdentity();
  if (dice_.chance(30))
    gl_.Ortho(-3, 3, -3, 3, 1, 12);
  else
    gl_.Frustum(-0.5, 0.5, -0.5, 0.5, 1, 2 + dice_.real(6, 60));
  gl_.MatrixMode(GL_MODELVIEW), gl_.LoadIdentity();
  gl_.Translatef(0, 0, -6), gl_.Rotatef(dice_.real(-60, 60), dice_.real(-1, 1), 1, 0.1f);
}

void Scene::texture(GLuint name) {
  constexpr uint32_t kTexels = 8;
  std::array<GLubyte, 4 * kTexels * kTexels> texels;
  for (GLubyte& t : texels) t = static_cast<GLubyte>(dice_.below(256));
  gl_.BindTexture(GL_TEXTURE_2D, name);
  const GLenum format = dice_.pick({GL_RGBA, GL_RGBA, GL_LUMINANCE_ALPHA});
  gl_.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(dice_.pick({GL_RGBA, GL_RGB, GL_LUMINANCE})), kTexels,
                 kTexels, 0, format, GL_UNSIGNED_BYTE, texels.data());
  const auto filter = static_cast<GLint>(dice_.pick({GL_NEAREST, GL_LINEAR}));
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S,
                    static_cast<GLint>(dice_.pick({GL_REPEAT, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT})));
}

void Scene::lights() {
  toggle(GL_LIGHTING, 75);
  for (GLenum light = GL_LIGHT0; light < GL_LIGHT0 + 3; ++light) {
    toggle(light, light == GL_LIGHT0 ? 90 : 30);
    const std::array<GLfloat, 4> position = {dice_.real(-4, 4), dice_.real(-4, 4), dice_.real(0, 4),
                                             dice_.chance(50) ? 1.0f : 0.0f};
    gl_.Lightfv(light, GL_POSITION, position.data());
    gl_.Lightfv(light, GL_DIFFUSE, dice_.color().data());
    gl_.Lightfv(light, GL_SPECULAR, dice_.color().data());
    gl_.Lightf(light, GL_SPOT_CUTOFF, dice_.chance(20) ? dice_.real(20, 60) : 180);
    const std::array<GLfloat, 3> direction = {dice_.real(-1, 1), dice_.real(-1, 1), -1};
    gl_.Lightfv(light, GL_SPOT_DIRECTION, direction.data());
    gl_.Lightf(light, GL_LINEAR_ATTENUATION, dice_.chance(20) ? dice_.real(0, 0.3f) : 0);
  }
  gl_.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, dice_.chance(40));
  gl_.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, dice_.chance(30));
  gl_.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                  static_cast<GLint>(dice_.pick({GL_SINGLE_COLOR, GL_SEPARATE_SPECULAR_COLOR})));
}

void Scene::material(GLenum face) {
  gl_.Materialfv(face, dice_.pick({GL_DIFFUSE, GL_AMBIENT, GL_AMBIENT_AND_DIFFUSE, GL_SPECULAR, GL_EMISSION}),
                 dice_.color().data());
  if (dice_.chance(50)) gl_.Materialf(face, GL_SHININESS, dice_.real(1, 60));
}

void Scene::surfaceState() {
  if (dice_.chance(60)) material(dice_.pick({GL_FRONT, GL_BACK, GL_FRONT_AND_BACK}));
  if (dice_.chance(40)) {
    gl_.ColorMaterial(dice_.pick({GL_FRONT, GL_FRONT_AND_BACK}),
                      dice_.pick({GL_DIFFUSE, GL_AMBIENT_AND_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_AMBIENT}));
    toggle(GL_COLOR_MATERIAL, 60);
  }
  gl_.ShadeModel(dice_.chance(80) ? GL_SMOOTH : GL_FLAT);
  toggle(GL_NORMALIZE, 80), toggle(GL_CULL_FACE, 25);
  gl_.CullFace(dice_.pick({GL_FRONT, GL_BACK, GL_BACK})), gl_.FrontFace(dice_.chance(80) ? GL_CCW : GL_CW);
  toggle(GL_TEXTURE_2D, 30), gl_.BindTexture(GL_TEXTURE_2D, 1 + dice_.below(2));
  gl_.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE,
              static_cast<GLint>(dice_.pick({GL_MODULATE, GL_REPLACE, GL_DECAL, GL_BLEND, GL_ADD})));
  toggle(GL_POLYGON_OFFSET_FILL, 20), gl_.PolygonOffset(dice_.real(-2, 2), dice_.real(-50, 50));
  if (dice_.chance(10)) gl_.PolygonMode(GL_FRONT_AND_BACK, dice_.pick({GL_FILL, GL_LINE, GL_FILL}));
  toggle(GL_CLIP_PLANE0, 15);
  const std::array<GLdouble, 4> plane = {dice_.real(-1, 1), 1, dice_.real(-1, 1), dice_.real(0, 1)};
  gl_.ClipPlane(GL_CLIP_PLANE0, plane.data());
}

void Scene::fragmentState() {
  toggle(GL_FOG, 20), gl_.Fogi(GL_FOG_MODE, static_cast<GLint>(dice_.pick({GL_LINEAR, GL_EXP, GL_EXP2})));
  gl_.Fogf(GL_FOG_DENSITY, dice_.real(0, 0.3f)), gl_.Fogf(GL_FOG_START, 3),
      gl_.Fogf(GL_FOG_END, dice_.real(6, 12));
  gl_.Fogfv(GL_FOG_COLOR, dice_.color().data());
  toggle(GL_ALPHA_TEST, 15), gl_.AlphaFunc(dice_.pick({GL_GREATER, GL_LESS, GL_GEQUAL}), 0.4f);
  toggle(GL_BLEND, 20),
      gl_.BlendFunc(dice_.pick({GL_SRC_ALPHA, GL_ONE}), dice_.pick({GL_ONE_MINUS_SRC_ALPHA, GL_ONE}));
  gl_.DepthFunc(dice_.pick({GL_LESS, GL_LEQUAL, GL_LESS, GL_GREATER})), gl_.DepthMask(dice_.chance(90));
  toggle(GL_STENCIL_TEST, 15), gl_.StencilFunc(dice_.pick({GL_ALWAYS, GL_EQUAL, GL_NOTEQUAL}), 1, 0xff);
  gl_.StencilOp(GL_KEEP, GL_KEEP, dice_.pick({GL_REPLACE, GL_INCR, GL_KEEP}));
  toggle(GL_SCISSOR_TEST, 10), gl_.Scissor(10, 20, 70, 60);
  gl_.ColorMask(GL_TRUE, dice_.chance(95), GL_TRUE, GL_TRUE);
}

void Scene::object() {
  gl_.PushMatrix();
  gl_.Translatef(dice_.real(-1.5f, 1.5f), dice_.real(-1.5f, 1.5f), dice_.real(-1.5f, 1.5f));
  gl_.Rotatef(dice_.real(0, 360), dice_.real(-1, 1), dice_.real(-1, 1), 1);
  const float size = dice_.real(0.4f, 1.6f);
  gl_.Scalef(size, size * dice_.real(0.6f, 1.2f), size);
  gl_.Color4fv(dice_.color().data());
  const Shape shape = makeShape(dice_);
  const uint32_t how = dice_.below(5);
  if (how == 4) {
    gl_.NewList(++lists_, dice_.pick({GL_COMPILE, GL_COMPILE_AND_EXECUTE}));
    if (dice_.chance(30)) material(GL_FRONT_AND_BACK);
    sendShape(gl_, shape, Sending::begin, dice_);
    gl_.EndList();
    gl_.Translatef(dice_.real(-1, 1), 0, 0), gl_.CallList(lists_);
    // Its last colour: see sendShape().
    GLfloat asked[4];
    gl_.GetFloatv(GL_CURRENT_COLOR, asked);
  } else {
    sendShape(gl_, shape, static_cast<Sending>(how), dice_);
  }
  gl_.PopMatrix();
}

/// Lines or points with colours and materials of their own.
void Scene::mark() {
  gl_.Begin(dice_.pick({GL_LINES, GL_POINTS, GL_LINE_STRIP}));
  for (int i = 0; i < 4; ++i) {
    if (dice_.chance(50)) gl_.Color4fv(dice_.color().data());
    if (dice_.chance(30)) gl_.Materialfv(GL_FRONT, GL_DIFFUSE, dice_.color().data());
    gl_.Vertex3f(dice_.real(-2, 2), dice_.real(-2, 2), dice_.real(-2, 2));
  }
  gl_.End();
}

void Scene::ask() {
  std::array<GLfloat, 4> v{};
  const auto keep = [&] { answers_.insert(answers_.end(), v.begin(), v.end()); };
  if (dice_.chance(50)) gl_.GetFloatv(GL_CURRENT_COLOR, v.data()), keep();
  if (dice_.chance(50)) gl_.GetMaterialfv(GL_FRONT, GL_DIFFUSE, v.data()), keep();
  if (dice_.chance(50)) gl_.GetMaterialfv(GL_BACK, GL_AMBIENT, v.data()), keep();
  answers_.push_back(static_cast<float>(gl_.GetError()));
}

}  // namespace

void drawScene(const gl::RealGl& gl, uint64_t seed, std::vector<float>& answers) {
  Scene(gl, seed, answers).draw();
}

}  // namespace gluray::fuzz
