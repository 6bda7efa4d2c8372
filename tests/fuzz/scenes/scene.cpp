#include "tests/fuzz/scenes/scene.h"

#include "tests/fuzz/scenes/arrays.h"
#include "tests/fuzz/scenes/shape.h"
#include "tests/fuzz/scenes/state.h"
#include "tests/fuzz/scenes/vertices.h"

#include <GL/gl.h>
#include <GL/glext.h>

namespace gluray::fuzz {
namespace {

/// Writes one scene.
class Scene {
 public:
  Scene(uint64_t seed, bool lists) : dice_(seed), callsLists_(lists) {}
  std::vector<Call> write();

 private:
  void pop();
  void clear();
  void change();
  void object();
  void place();
  void send(const Shape& shape, bool list, bool again);
  void list(const Shape& shape);
  void listStep(const Shape& shape);
  void current();
  void ask();

  Dice dice_;
  std::vector<Call> calls_;
  Writer w_{dice_, calls_};
  GLuint lists_ = 0;
  bool executes_ = false;  // the list that is being compiled is executed, too
  bool callsLists_;
  // How often some calls appear in this scene.
  uint32_t materials_ = 0, colorMaterials_ = 0, listShare_ = 0, arrayShare_ = 0;
};

std::vector<Call> Scene::write() {
  materials_ = dice_.below(60), colorMaterials_ = dice_.below(60);
  listShare_ = callsLists_ ? dice_.below(60) : 0, arrayShare_ = 20 + dice_.below(60);
  w_.twoSided = dice_.chance(60);
  WRITE(w_, Enable, GLenum{GL_DEPTH_TEST});
  clear();
  WRITE(w_, Materialf, GLenum{GL_FRONT_AND_BACK}, GLenum{GL_SHININESS}, 8.0f);  // 0: avoided.md
  for (uint32_t name = 1; name < 3; ++name) writeTexture(w_, name);
  writeCamera(w_, kSceneSize), writeLights(w_), writeClipPlanes(w_);
  const uint32_t objects = 2 + dice_.below(6);
  for (uint32_t i = 0; i < objects; ++i) {
    if (dice_.chance(60)) change();
    const bool saves = dice_.chance(20);
    if (saves)
      WRITE_AS(w_, push, PushAttrib,
               dice_.pick({GL_ALL_ATTRIB_BITS, GL_CURRENT_BIT, GL_LIGHTING_BIT, GL_ENABLE_BIT,
                           GL_CURRENT_BIT | GL_LIGHTING_BIT}));
    if (saves && dice_.chance(50)) change();
    object();
    if (dice_.chance(20)) writeMarks(w_);
    if (dice_.chance(30)) ask();
    if (saves) pop();
    if (dice_.chance(10)) writeCamera(w_, kSceneSize);
    if (dice_.chance(6)) clear();
  }
  ask();
  return std::move(calls_);
}

/// glPopAttrib, after a query of the colour: avoided.md.
void Scene::pop() {
  askColor(w_);
  WRITE_AS(w_, pop, PopAttrib);
  w_.join(2);
}

void Scene::clear() {
  const auto background = dice_.color();
  WRITE(w_, ClearColor, background[0], background[1], background[2], 1.0f);
  WRITE(w_, Clear, GLbitfield{GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT});
}

/// Changes of state in any order.
void Scene::change() {
  for (uint32_t i = 1 + dice_.below(4); i > 0; --i) {
    if (dice_.chance(40)) writeSurface(w_);
    if (dice_.chance(30)) writeFragments(w_);
    if (dice_.chance(15)) writeLights(w_);
    if (dice_.chance(materials_)) writeMaterial(w_);
    if (dice_.chance(colorMaterials_)) writeColorMaterial(w_);
    if (dice_.chance(30)) current();
  }
}

void Scene::place() {
  const float x = dice_.real(-1.5f, 1.5f), y = dice_.real(-1.5f, 1.5f), z = dice_.real(-1.5f, 1.5f);
  WRITE(w_, Translatef, x, y, z);
  const float angle = dice_.real(0, 360), u = dice_.real(-1, 1), v = dice_.real(-1, 1);
  WRITE(w_, Rotatef, angle, u, v, 1.0f);
  const float size = dice_.real(0.4f, 1.6f), aspect = dice_.real(0.6f, 1.2f);
  WRITE(w_, Scalef, size, size * aspect, size);
}

/// Current attributes.
void Scene::current() {
  if (dice_.chance(60)) WRITE(w_, Color4fv, dice_.color());
  if (dice_.chance(20)) WRITE(w_, Normal3f, dice_.real(-1, 1), 0.5f, 1.0f);
  if (dice_.chance(20)) WRITE(w_, TexCoord2f, dice_.real(0, 2), 0.3f);
}

/// `again`: the shape may be drawn again at the same place. Then it always consists of the same triangles,
/// whose depths are equal: avoided.md.
void Scene::send(const Shape& shape, bool list, bool again) {
  const Attributes attributes = makeAttributes(dice_);
  if (dice_.chance(arrayShare_)) {
    // So that Mesa keeps the attributes of a primitive before it: avoided.md.
    const size_t before = calls_.size();
    if (list) WRITE(w_, Normal3f, dice_.real(-1, 1), 0.5f, 1.0f);
    writeArrays(w_, shape, attributes, list);
    w_.join(calls_.size() - before);
  } else if (dice_.chance(15)) {
    writeArrayElements(w_, shape, attributes);
  } else {
    writePrimitives(w_, shape, attributes, again,
                    !dice_.chance(materials_ / 3) ? Materials::none
                    : list                        ? Materials::inLists
                                                  : Materials::anywhere);
  }
}

void Scene::listStep(const Shape& shape) {
  switch (dice_.below(10)) {
    case 0: return current();
    case 1: {
      const size_t before = calls_.size();
      if (executes_) WRITE(w_, Translatef, 0.1f, 0.0f, 0.1f);  // avoided.md
      writeMaterial(w_);
      return w_.join(calls_.size() - before);
    }
    case 2:
      if (dice_.chance(colorMaterials_)) writeColorMaterial(w_, Asks::nothing);
      return;
    case 3: writeToggle(w_, dice_.pick({GL_LIGHTING, GL_NORMALIZE, GL_CULL_FACE, GL_TEXTURE_2D}), 60); return;
    case 4: return WRITE(w_, Translatef, dice_.real(-1, 1), 0.3f, 0.2f);
    case 5:
      if (lists_ > 1) WRITE(w_, CallList, GLuint{1 + dice_.below(lists_ - 1)});
      return;
    default: {
      const bool again = dice_.chance(50);
      return send(again ? shape : makeShape(dice_), true, again || executes_);
    }
  }
}

void Scene::list(const Shape& shape) {
  executes_ = dice_.chance(33);
  WRITE_AS(w_, newList, NewList, ++lists_, executes_ ? GLenum{GL_COMPILE_AND_EXECUTE} : GLenum{GL_COMPILE});
  const bool saves = dice_.chance(20);
  if (saves)
    WRITE_AS(w_, push, PushAttrib, dice_.pick({GL_CURRENT_BIT, GL_LIGHTING_BIT, GL_ALL_ATTRIB_BITS}));
  for (uint32_t i = 1 + dice_.below(5); i > 0; --i) listStep(shape);
  if (saves) WRITE_AS(w_, pop, PopAttrib);
  WRITE_AS(w_, endList, EndList);
  for (uint32_t calls = 1 + dice_.below(2); calls > 0; --calls) {
    // Flat shapes leave their plane: avoided.md.
    if (dice_.chance(60)) WRITE(w_, Translatef, dice_.real(-1, 1), -0.3f, 0.15f);
    if (dice_.chance(40)) current();
    if (dice_.chance(20)) change();
    WRITE(w_, CallList, lists_);
    WRITE(w_, Translatef, 0.1f, 0.0f, 0.1f);  // a change of state: avoided.md
    w_.join(2);
  }
}

/// A shape, drawn once, or several times at one place in several ways.
void Scene::object() {
  WRITE_AS(w_, push, PushMatrix);
  place();
  if (dice_.chance(60)) current();
  const Shape shape = makeShape(dice_);
  const uint32_t all = dice_.chance(70) ? 1 : 2 + dice_.below(2);
  for (uint32_t layers = all; layers > 0; --layers) {
    if (dice_.chance(listShare_))
      list(shape);
    else
      send(shape, false, all > 1);
    w_.samePlace = true;
    if (layers > 1 && dice_.chance(70)) change();
    w_.samePlace = false;
  }
  WRITE_AS(w_, pop, PopMatrix);
}

void Scene::ask() {
  const auto keep = [](const GLfloat* v, int n, Answers& answers) {
    answers.insert(answers.end(), v, v + n);
  };
  for (const GLenum name : {GL_CURRENT_COLOR, GL_CURRENT_NORMAL, GL_CURRENT_TEXTURE_COORDS})
    if (dice_.chance(40))
      w_.call("glGetFloatv(" + printed(name) + ")", [=](Gl gl, Answers& answers) {
        GLfloat v[4] = {};
        gl.GetFloatv(name, v), keep(v, name == GL_CURRENT_NORMAL ? 3 : 4, answers);
      });
  for (const GLenum face : {GL_FRONT, GL_BACK})
    for (const GLenum name : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION})
      if (dice_.chance(25))
        w_.call("glGetMaterialfv(" + printed(face) + ", " + printed(name) + ")",
                [=](Gl gl, Answers& answers) {
                  GLfloat v[4] = {};
                  gl.GetMaterialfv(face, name, v), keep(v, 4, answers);
                });
  w_.call("glGetError()",
          [](Gl gl, Answers& answers) { answers.push_back(static_cast<float>(gl.GetError())); });
}

}  // namespace

std::vector<Call> makeScene(uint64_t seed, bool lists) { return Scene(seed, lists).write(); }

void playScene(Gl gl, const std::vector<Call>& calls, Answers& answers) {
  for (const Call& call : calls) call.play(gl, answers);
}

}  // namespace gluray::fuzz
