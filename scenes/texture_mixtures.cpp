// Textures together with what else a program sets: lists, the attribute stack, fog, clip planes, offsets,
// changes between two draws.
#include "scenes/families.h"
#include "scenes/stage.h"
#include "scenes/texels.h"

namespace gluray::scenes {
namespace {

constexpr Tolerance kMixed{
    3, 0.004, 1e-5f, "borders of texels and edges of triangles that move with the last bits of coordinates"};

void mixtureStage(Gl gl, int width, int height, GLint filter = GL_LINEAR) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  paint(gl, 0.9f, 0.9f, 0.9f);
  gl.Enable(GL_TEXTURE_2D);
  upload(gl, GL_RGB, 16, filter, GL_REPEAT);
}

/// One list sets everything, draws, and puts it back; the next draw must find nothing of it.
void listOfEverything(Gl gl, int width, int height) {
  mixtureStage(gl, width, height);
  gl.Disable(GL_TEXTURE_2D);
  const Color fog{0.6f, 0.7f, 0.8f, 1};
  const double plane[] = {0.3, 1, 0.2, 0.1};
  const GLuint list = gl.GenLists(1);
  gl.NewList(list, GL_COMPILE);
  gl.PushAttrib(GL_ALL_ATTRIB_BITS);
  gl.Enable(GL_TEXTURE_2D);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
  material(gl, GL_BACK, GL_AMBIENT_AND_DIFFUSE, {0.9f, 0.3f, 0.2f, 1});
  gl.Enable(GL_FOG);
  gl.Fogi(GL_FOG_MODE, GL_LINEAR);
  gl.Fogf(GL_FOG_START, 3), gl.Fogf(GL_FOG_END, 6);
  gl.Fogfv(GL_FOG_COLOR, fog.data());
  gl.ClipPlane(GL_CLIP_PLANE0, plane);
  gl.Enable(GL_CLIP_PLANE0);
  send(gl, vase(30, 20), kNormals | kTexcoords);
  gl.PopAttrib();
  gl.EndList();
  gl.Translatef(-0.9f, 0, 0);
  gl.CallList(list);
  gl.Translatef(1.8f, 0, 0);
  gl.Rotatef(60, 1, 0, 0);
  send(gl, vase(30, 20), kNormals | kTexcoords);
  gl.Translatef(-0.9f, -1, -1);
  gl.CallList(list);
}

/// The unit that arrays are set for and the one that textures are set for differ.
void unitsApart(Gl gl, int width, int height) {
  mixtureStage(gl, width, height);
  gl.ActiveTexture(GL_TEXTURE1);
  bindFresh(gl, GL_TEXTURE_2D);
  upload(gl, GL_LUMINANCE, 8, GL_NEAREST, GL_REPEAT);
  gl.Enable(GL_TEXTURE_2D);
  const Model model = sphere(24, 36);
  std::vector<float> scaled = model.texcoords;
  for (float& c : scaled) c *= 3;
  gl.EnableClientState(GL_VERTEX_ARRAY), gl.EnableClientState(GL_NORMAL_ARRAY);
  gl.VertexPointer(3, GL_FLOAT, 0, model.positions.data());
  gl.NormalPointer(GL_FLOAT, 0, model.normals.data());
  gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
  gl.TexCoordPointer(2, GL_FLOAT, 0, model.texcoords.data());
  gl.ClientActiveTexture(GL_TEXTURE1);
  gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
  gl.TexCoordPointer(2, GL_FLOAT, 0, scaled.data());
  gl.ActiveTexture(GL_TEXTURE0);
  const auto count = static_cast<GLsizei>(model.indices.size());
  const auto draw = [&](float x) {
    gl.PushMatrix();
    gl.Translatef(x, 0, 0), gl.Scalef(0.6f, 0.6f, 0.6f);
    gl.DrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, model.indices.data());
    gl.PopMatrix();
  };
  draw(-1.2f);
  // The array of unit 1 goes; its current coordinates are for all vertices.
  gl.DisableClientState(GL_TEXTURE_COORD_ARRAY);
  gl.MultiTexCoord2f(GL_TEXTURE1, 0.1f, 0.6f);
  draw(0);
  gl.ClientActiveTexture(GL_TEXTURE0);
  gl.TexCoordPointer(2, GL_FLOAT, 0, scaled.data());
  gl.Disable(GL_TEXTURE_2D);
  gl.ActiveTexture(GL_TEXTURE1), gl.Disable(GL_TEXTURE_2D);
  gl.ActiveTexture(GL_TEXTURE0), gl.Enable(GL_TEXTURE_2D);
  draw(1.2f);
}

/// One list called again and again while its texture gets other texels, another filter and another wrap.
void changedBetweenCalls(Gl gl, int width, int height) {
  mixtureStage(gl, width, height);
  const GLuint list = gl.GenLists(1);
  gl.NewList(list, GL_COMPILE);
  gl.Translatef(0.8f, 0, 0);
  sendAt(gl, sphere(20, 30), 0, 0, 0, 0.35f, kNormals | kTexcoords);
  gl.EndList();
  gl.Translatef(-2, 0, 0);
  gl.CallList(list);
  const std::vector<uint8_t> white(8 * 8 * 4, 255);
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 4, 4, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
  gl.CallList(list);
  gl.MatrixMode(GL_TEXTURE), gl.Scalef(3, 3, 1), gl.MatrixMode(GL_MODELVIEW);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.CallList(list);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  gl.CallList(list);
}

/// Generated coordinates under a texture matrix, while the object moves.
void generatedAndMoved(Gl gl, int width, int height) {
  mixtureStage(gl, width, height);
  gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR);
  gl.TexGeni(GL_T, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
  gl.Enable(GL_TEXTURE_GEN_S), gl.Enable(GL_TEXTURE_GEN_T);
  gl.MatrixMode(GL_TEXTURE);
  gl.Rotatef(30, 0, 0, 1), gl.Scalef(1.5f, 0.7f, 1);
  gl.MatrixMode(GL_MODELVIEW);
  for (int i = 0; i < 4; ++i) {
    gl.PushMatrix();
    gl.Translatef(static_cast<float>(i) * 0.8f - 1.2f, 0, 0);
    gl.Rotatef(static_cast<float>(i) * 40, 1, 1, 0);
    gl.Scalef(0.35f, 0.35f, 0.35f);
    send(gl, torus(0.9f, 0.4f, 30, 16));
    gl.PopMatrix();
    gl.MatrixMode(GL_TEXTURE), gl.Translatef(0.1f, 0.2f, 0), gl.MatrixMode(GL_MODELVIEW);
  }
}

/// The same triangles again, with holes: what lies in the holes is the first surface.
void holesUponItself(Gl gl, int width, int height) {
  mixtureStage(gl, width, height, GL_NEAREST);
  upload(gl, GL_RGBA, 16, GL_NEAREST, GL_REPEAT);
  const Model model = sphere(24, 36);
  for (const GLenum function : {GL_LESS, GL_LEQUAL}) {
    gl.PushMatrix();
    gl.Translatef(function == GL_LESS ? -0.9f : 0.9f, 0, 0), gl.Scalef(0.8f, 0.8f, 0.8f);
    gl.DepthFunc(function);
    gl.Enable(GL_ALPHA_TEST), gl.Enable(GL_TEXTURE_2D);
    gl.AlphaFunc(GL_GREATER, 0.5f);
    paint(gl, 0.9f, 0.9f, 0.9f);
    send(gl, model, kNormals | kTexcoords);
    gl.Disable(GL_TEXTURE_2D);
    paint(gl, 0.2f, 0.8f, 0.4f);
    send(gl, model, kNormals | kTexcoords);
    gl.Enable(GL_TEXTURE_2D);
    gl.AlphaFunc(GL_LESS, 0.5f);
    paint(gl, 0.9f, 0.2f, 0.2f);
    send(gl, model, kNormals | kTexcoords);
    gl.Disable(GL_ALPHA_TEST);
    gl.PopMatrix();
  }
}

/// A decal pulled towards the viewer by the offset, another pushed away.
void offsetDecals(Gl gl, int width, int height) {
  mixtureStage(gl, width, height);
  gl.Disable(GL_TEXTURE_2D);
  send(gl, torus(0.8f, 0.35f, 40, 24));
  gl.Enable(GL_TEXTURE_2D);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL);
  upload(gl, GL_RGBA, 16, GL_LINEAR, GL_REPEAT);
  gl.Enable(GL_POLYGON_OFFSET_FILL);
  Model half = torus(0.8f, 0.35f, 40, 24);
  half.indices.resize(half.indices.size() / 2);
  gl.PolygonOffset(-1, -4);
  paint(gl, 0.3f, 0.3f, 0.9f);
  send(gl, half, kNormals | kTexcoords);
  gl.PolygonOffset(1, 40);
  gl.Scalef(1.001f, 1.001f, 1.001f);
  paint(gl, 0.9f, 0.3f, 0.3f);
  send(gl, half, kNormals | kTexcoords);
}

/// The inner list sets the generation of coordinates and draws, the outer one moves and repeats.
void cubeMapInNestedLists(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  gl.Color3f(1, 1, 1);
  for (GLenum face = 0; face < 6; ++face) {
    auto texels = pattern(16);
    for (size_t i = 2; i < texels.size(); i += 4) texels[i] = static_cast<uint8_t>(40 * face + texels[i] / 6);
    gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGB, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  texels.data());
  }
  sampling(gl, GL_TEXTURE_CUBE_MAP, GL_LINEAR, GL_CLAMP_TO_EDGE);
  const GLuint inner = gl.GenLists(2), outer = inner + 1;
  gl.NewList(inner, GL_COMPILE);
  gl.PushAttrib(GL_ENABLE_BIT | GL_TEXTURE_BIT);
  gl.Enable(GL_TEXTURE_CUBE_MAP), gl.Enable(GL_NORMALIZE);
  for (const GLenum c : {GL_S, GL_T, GL_R}) {
    gl.TexGeni(c, GL_TEXTURE_GEN_MODE, GL_REFLECTION_MAP);
    gl.Enable(GL_TEXTURE_GEN_S + (c - GL_S));
  }
  send(gl, torus(0.6f, 0.3f, 40, 24));
  gl.PopAttrib();
  gl.EndList();
  gl.NewList(outer, GL_COMPILE);
  gl.PushMatrix();
  gl.Translatef(-0.8f, 0, 0), gl.Scalef(0.8f, 0.8f, 0.8f);
  gl.CallList(inner);
  gl.Translatef(2, 0, 0), gl.Rotatef(60, 1, 1, 0);
  gl.CallList(inner);
  gl.PopMatrix();
  sendAt(gl, sphere(12, 16), 0, 0.9f, 0, 0.3f);
  gl.EndList();
  gl.CallList(outer);
}

/// A texture goes while it is bound and drawn with, and its name comes back for another.
void deletedWhileBound(Gl gl, int width, int height) {
  mixtureStage(gl, width, height);
  GLuint name = bindFresh(gl, GL_TEXTURE_2D);
  upload(gl, GL_RGB, 4, GL_NEAREST, GL_REPEAT);
  sendAt(gl, sphere(20, 30), -1.2f, 0, 0, 0.5f, kNormals | kTexcoords);
  gl.DeleteTextures(1, &name);  // the default texture is bound now
  sendAt(gl, sphere(20, 30), 0, 0, 0, 0.5f, kNormals | kTexcoords);
  gl.BindTexture(GL_TEXTURE_2D, name);
  upload(gl, GL_LUMINANCE, 8, GL_NEAREST, GL_REPEAT);
  sendAt(gl, sphere(20, 30), 1.2f, 0, 0, 0.5f, kNormals | kTexcoords);
}

/// glPopAttrib brings back which texture was bound, its parameters and the unit's environment.
void bindingsPopped(Gl gl, int width, int height) {
  mixtureStage(gl, width, height);
  gl.PushAttrib(GL_TEXTURE_BIT);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  bindFresh(gl, GL_TEXTURE_2D);
  upload(gl, GL_LUMINANCE, 4, GL_NEAREST, GL_CLAMP_TO_EDGE);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR), gl.Enable(GL_TEXTURE_GEN_S);
  sendAt(gl, sphere(20, 30), -0.7f, 0, 0, 0.6f, kNormals | kTexcoords);
  gl.PopAttrib();
  sendAt(gl, sphere(20, 30), 0.7f, 0, 0, 0.6f, kNormals | kTexcoords);
}

/// Levels of a mipmapped texture are replaced one by one, and at last all of them by the automatic.
void levelsReplaced(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  gl.Color3f(1, 1, 1);
  gl.Enable(GL_TEXTURE_2D);
  sampling(gl, GL_TEXTURE_2D, GL_LINEAR, GL_REPEAT);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  tintedLevels(gl, 32);
  const auto strip = [&](float y) {
    gl.PushMatrix();
    gl.Translatef(0, y, 0), gl.Scalef(1, 0.8f, 1);
    ground(gl, 2);
    gl.PopMatrix();
  };
  strip(-0.6f);
  const std::vector<uint8_t> black(16 * 16 * 4, 20);
  gl.TexSubImage2D(GL_TEXTURE_2D, 1, 0, 0, 16, 8, GL_RGBA, GL_UNSIGNED_BYTE, black.data());
  gl.TexSubImage2D(GL_TEXTURE_2D, 2, 2, 2, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, black.data());
  gl.Scalef(1, -1, 1);
  strip(-0.6f);
  gl.TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 16, 16, GL_RGBA, GL_UNSIGNED_BYTE, black.data());
  sendAt(gl, sphere(20, 30), 0, 0, 1, 0.4f, kTexcoords);
}

/// What has been drawn so far becomes the texture of what comes next, twice.
void copiedInMidFrame(Gl gl, int width, int height) {
  mixtureStage(gl, width, height);
  sendAt(gl, torus(0.8f, 0.3f, 40, 24), -0.6f, 0.2f, 0, 0.8f, kNormals | kTexcoords);
  bindFresh(gl, GL_TEXTURE_2D);
  sampling(gl, GL_TEXTURE_2D, GL_NEAREST, GL_CLAMP_TO_EDGE);
  gl.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, width / 2 - 64, height / 2 - 32, 64, 64, 0);
  sendAt(gl, sphere(20, 30), 0.9f, 0.5f, 0, 0.4f, kNormals | kTexcoords);
  gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 16, 16, width / 2 + 20, height / 2, 32, 32);
  sendAt(gl, sphere(20, 30), 0.9f, -0.4f, 0, 0.4f, kNormals | kTexcoords);
}

constexpr Scene kTextureMixtureScenes[] = {
    {"texture-list-of-everything", listOfEverything, true, kMixed},
    {"texture-units-apart", unitsApart, true, kMixed},
    {"texture-changed-between-calls", changedBetweenCalls, true, kMixed},
    {"texture-generated-and-moved", generatedAndMoved, true, kMixed},
    {"texture-holes-upon-itself", holesUponItself, true, kMixed},
    {"texture-offset-decals", offsetDecals, true, kMixed},
    {"texture-cube-in-nested-lists", cubeMapInNestedLists, true, kMixed},
    {"texture-deleted-while-bound", deletedWhileBound, true, kMixed},
    {"texture-bindings-popped", bindingsPopped, true, kMixed},
    {"texture-levels-replaced", levelsReplaced, true, kMixed},
    {"texture-copied-in-mid-frame", copiedInMidFrame, true, kMixed},
};

}  // namespace

std::span<const Scene> textureMixtureScenes() { return kTextureMixtureScenes; }

}  // namespace gluray::scenes
