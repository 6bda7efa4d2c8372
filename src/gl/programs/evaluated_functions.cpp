#include "gl/programs/evaluated_functions.h"

#include "gl/families/variable_types.h"

#include <GL/glext.h>

#include <stdexcept>

namespace gluray::gl {

bool needFunctions(GlslStatements& statements, const Family& family, const CodeSections& code,
                   std::vector<std::string>& out) {
  FunctionNames functions;
  if (const std::string name = takeFunctions(statements, code, family.code, functions); !name.empty())
    return out.push_back(about("has several functions, or other calls, of ", name)), false;
  for (const auto& [name, function] : functions)
    if (!family.mentions(name))
      out.push_back(about("has a function for ", name, ", which the family does not use"));
  return true;
}

std::vector<std::shared_ptr<const glsl::ShaderFunctions>> functionsOf(ProgramSource& source) {
  std::vector<std::shared_ptr<const glsl::ShaderFunctions>> all;
  for (const GLenum type : {GL_VERTEX_SHADER, GL_FRAGMENT_SHADER}) try {
      all.push_back(std::make_shared<const glsl::ShaderFunctions>(source.textOf(type)));
    } catch (const std::runtime_error&) {  // it has none that can be evaluated
    }
  return all;
}

}  // namespace gluray::gl
