#include "gl/batch/program_draw.h"

#include "gl/arrays/arrays.h"
#include "gl/glsl/built_in_variables.h"
#include "gl/programs/built_in_uniforms.h"
#include "gl/programs/match.h"
#include "gl/real/state_queries.h"
#include "gl/state/state.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <utility>

namespace gluray::gl {
namespace {

void addArray(const RealGl& real, const ArraySource& source, std::vector<ProgramDraw::Array>& arrays) {
  if (!source.enabled || !source.buffer) return;
  const auto location = static_cast<GLuint>(source.location);
  const auto ask = [&](GLenum name) {
    GLint value = 0;
    real.GetVertexAttribiv(location, name, &value);
    return value;
  };
  ProgramDraw::Array array;
  array.location = location;
  array.size = source.size;
  array.type = source.type;
  array.normalized = source.normalized;
  array.integer = ask(GL_VERTEX_ATTRIB_ARRAY_INTEGER) != 0;
  array.stride = source.stride;
  array.offset = reinterpret_cast<size_t>(source.pointer);
  array.divisor = source.divisor;
  array.contents = source.buffer->read(real);
  if (array.contents) arrays.push_back(std::move(array));
}

/// Captures the program's inputs other than vertices, and the state of polygons, lines and points.
ProgramDraw captureInputs(const RealGl& real, const Program& program, const UniformValuesPtr& uniforms) {
  ProgramDraw draw;
  draw.program = program.name;
  draw.uniforms = uniforms;
  if (program.blocks) draw.blocks = readBlocks(real, program.name);
  const GLint active = integer(real, GL_ACTIVE_TEXTURE);
  for (const auto& [name, uniform] : program.uniforms) {
    const SamplerTarget target = samplerTarget(uniform.type);
    if (!target.binding) continue;
    const GLint unit = (*uniforms)[uniform.first].integers[0];
    real.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    GLint buffer = 0;
    if (target.target == GL_TEXTURE_BUFFER)
      real.GetTexLevelParameteriv(GL_TEXTURE_BUFFER, 0, GL_TEXTURE_BUFFER_DATA_STORE_BINDING, &buffer);
    draw.textures.push_back({static_cast<GLuint>(unit), target,
                             static_cast<GLuint>(integer(real, target.binding)),
                             static_cast<GLuint>(buffer)});
  }
  real.ActiveTexture(static_cast<GLenum>(active));
  real.GetFloatv(GL_POINT_SIZE, &draw.pointSize);
  real.GetFloatv(GL_LINE_WIDTH, &draw.lineWidth);
  draw.offset = isOn(real, GL_POLYGON_OFFSET_FILL);
  real.GetFloatv(GL_POLYGON_OFFSET_FACTOR, &draw.offsetFactor);
  real.GetFloatv(GL_POLYGON_OFFSET_UNITS, &draw.offsetUnits);
  draw.cull = isOn(real, GL_CULL_FACE);
  draw.cullFace = static_cast<GLenum>(integer(real, GL_CULL_FACE_MODE));
  draw.frontFace = static_cast<GLenum>(integer(real, GL_FRONT_FACE));
  return draw;
}

bool reads(const Family& family, BuiltInUniform::Of what) {
  return std::ranges::any_of(family.mentioned,
                             [&](const std::string& name) { return builtInUniform(name).of == what; });
}

/// The parameters of fog, which programs read whether GL_FOG is on or off.
scene::Fog fogParameters(const RealGl& real) {
  scene::Fog fog;
  fog.mode = scene::Fog::exp;
  real.GetFloatv(GL_FOG_DENSITY, &fog.density);
  real.GetFloatv(GL_FOG_START, &fog.start);
  real.GetFloatv(GL_FOG_END, &fog.end);
  GLfloat color[4] = {};
  real.GetFloatv(GL_FOG_COLOR, color);
  fog.color = {color[0], color[1], color[2]};
  return fog;
}

/// Number of lights that the family's programs may read.
GLuint lightsOf(const Family& family) {
  GLuint count = 0;
  for (const std::string& name : family.mentioned) {
    const BuiltInUniform u = builtInUniform(name);
    if (u.of == BuiltInUniform::Of::light || u.of == BuiltInUniform::Of::product)
      count = std::max(count, u.light + 1);
  }
  return count;
}

}  // namespace

ProgramDraw captureProgramDraw(const RealGl& real, const Program& program, const UniformValuesPtr& uniforms,
                               const ArrayState& attributes, GLenum mode, const Elements& elements) {
  ProgramDraw draw = captureInputs(real, program, uniforms);
  draw.mode = mode;
  draw.elements = elements;
  attributes.forEach([&](const ArraySource& source) { addArray(real, source, draw.arrays); });
  for (const ArraySource& source : attributes.generic) addArray(real, source, draw.arrays);
  if (elements.type && attributes.elements) draw.indexContents = attributes.elements->read(real);
  return draw;
}

ProgramDraw captureBuiltInDraw(const RealGl& real, const KnownProgram& known,
                               const UniformValuesPtr& uniforms, scene::Instance instance) {
  ProgramDraw draw = captureInputs(real, known.program, uniforms);
  auto inputs = std::make_shared<BuiltInInputs>();
  inputs->instance = std::move(instance);
  scene::MaterialPair material;
  readMaterial(real, material);
  inputs->instance.materials = {material};
  for (GLuint i = 0; i < lightsOf(*known.family); ++i)
    inputs->state.lights.push_back(readLight(real, GL_LIGHT0 + i));
  real.GetFloatv(GL_LIGHT_MODEL_AMBIENT, glm::value_ptr(inputs->state.globalAmbient));
  if (reads(*known.family, BuiltInUniform::Of::fog)) inputs->state.fog = fogParameters(real);
  if (reads(*known.family, BuiltInUniform::Of::textureMatrix)) {
    UniformValue matrix;
    readBuiltIn(real, "gl_TextureMatrix[0]", matrix);
    inputs->textureMatrix = glm::make_mat4(matrix.floats.data());
  }
  draw.builtIn = std::move(inputs);
  return draw;
}

}  // namespace gluray::gl
