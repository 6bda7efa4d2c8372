// Interprets one shader program's uniforms, textures and attributes as its family describes them. Private to
// gl/program_state. GL thread.
#pragma once
#include "gl/program_state/program_state.h"
#include "gl/programs/uniforms.h"
#include "gl/sharing/share_group.h"
#include "gl/textures/texture_cache.h"

#include <string>
#include <utility>

namespace gluray::gl {

/// Reads one program. Use an object once.
class ProgramReader {
 public:
  ProgramReader(const RealGl& real, ShareGroup& group, const RareState& has, TextureCache& textures,
                ProgramState& out)
      : real_(real),
        group_(group),
        has_(has),
        textures_(textures),
        out_(out),
        program_(out.known->program),
        family_(*out.known->family),
        uniforms_(program_, *out.uniforms, out.known->placeholders) {}

  Reason read();

 private:
  /// Refuses the draw; `why` is shown to the user.
  Reason refuse(std::string why) { return out_.why = std::move(why), Reason::programValue; }
  /// Checks the uniforms that must have neutral values (Family::neutral).
  Reason checkNeutral();
  /// Checks fixed function's state that changes the output of shader programs with gl_Vertex.
  Reason checkBuiltInState();
  Reason readTransform();
  /// Reads the matrices of families that name functions (Family::linesOfSight, Family::eyeAgain).
  Reason readSight();
  /// Places the viewer. `toViewer`: homogeneous; w is 0 of one at infinity.
  void placeViewer(const glm::dvec4& toViewer);
  /// Turns directions of lights into the space of the viewer, and drops highlights without an exponent.
  void turnLights();
  Reason readWindow();
  void readMaterial(const FamilyMaterial& m, scene::Material& material);
  void readBackMaterial();
  /// Finds out whether back faces are invisible. Call it after the colours have been read.
  Reason readBackVisibility();
  /// One of the values is a number or an active uniform.
  bool isActive(const FamilyValue& value, const FamilyValue& factor = {}) const;
  void readModel();
  void readFog();
  /// Reads the unlit colours if the program's lights are switched off (FamilyLights::enabled).
  Reason readEnabled();
  Reason readImpostors();
  Reason readSplats();
  Reason readSentBillboards();
  void readClipPlanes();
  void readDepthOffset();
  Reason readNormals();
  Reason readEdges();
  Reason readColor();
  /// Gives back faces the front's factors of the colours, if the program uses these colours for both sides.
  Reason readBackColors();
  Reason readHeightColors();
  /// Reads the exponent of colours that are not the material's, and applies it to the material's factors.
  Reason readColorExponent();
  /// If the material's colours replace all others, their opacity still counts: refuses translucent colours.
  /// The opacity of vertex colours is checked with the mesh.
  Reason readOpacityBeneath();
  const ProgramUniform* samplerNamed(const std::string& name) const {
    return name.empty() ? nullptr : program_.uniform(name);
  }
  GLint unitOf(const ProgramUniform& sampler) const { return (*out_.uniforms)[sampler.first].integers[0]; }
  Reason readTexcoordMatrix();
  Reason readMap(const ProgramUniform& sampler);
  Reason readMatcap();
  Reason readBuffer(const ProgramUniform& sampler, scene::Attribute& attribute, uint32_t& count);
  /// Reads the vertices of a family that pulls them (pulled_vertices.h). Call it before colours, normals and
  /// edges are read.
  Reason readPulled();
  Reason readPulledArrays(ArrayState& arrays);
  Reason readPulledIntegers(const std::string& name, BufferTexture& integers);
  Reason readPulledCells(PulledVertices& pulled);
  /// Moves the start of values of triangles, or of cells, to those of the pulled draw. `offset`: the name of
  /// their uniform.
  Reason shiftTriangles(const std::string& offset, scene::Attribute& attribute, uint32_t& count);
  Reason readTextures();
  /// Reads the texture of a sampler into `texture`, with the family's texture coordinates.
  Reason readTexture(const ProgramUniform& sampler, scene::Texture& texture);
  Reason readPbr();
  /// Appends the texture of sampler `name` to those of the surface and sets `index`, if the sampler is
  /// active.
  Reason readPbrTexture(const std::string& name, int& index);
  Reason readEnvironment();
  /// The current value of an attribute whose array is not enabled.
  glm::vec4 current(const std::string& name) const;

  const RealGl& real_;
  ShareGroup& group_;
  const RareState& has_;
  TextureCache& textures_;
  ProgramState& out_;
  const Program& program_;
  const Family& family_;
  const UniformReader uniforms_;
  glm::dvec3 viewer_{0};
  bool seenFromInfinity_ = false;  // along +z, by Family::linesOfSight
  glm::dmat3 turn_{1};             // of the space of lights, which puts the viewer there
  glm::mat4 texcoordMatrix_{1};
};

}  // namespace gluray::gl
