// Evaluates gl_Position of a vertex shader if it is a matrix, which may depend on instance attributes, times
// one attribute; and tests whether a fragment shader's alpha is 1. Interprets the statements on which these
// depend, with the current values of uniforms. Any thread.
#pragma once
#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace gluray::gl {

/// Values of the uniforms of a shader program, in use while PositionSlice::evaluate() runs.
class UniformSource {
 public:
  virtual ~UniformSource() = default;
  /// Components of the active uniform `name` ("matrices[2]", "light.position", "Block.member" or the member
  /// of a block without instance name; built-in state such as "gl_ModelViewProjectionMatrix"), matrices
  /// column by column; booleans 0 or 1. Returns false if unknown.
  virtual bool read(std::string_view name, std::vector<double>& components) const = 0;
  /// Whether the float components of uniform `name` stay symbolic, like those of instance attributes.
  /// LinearPosition::columns then contains the uniform's name in place of an attribute's.
  virtual bool isSymbolic(std::string_view /*name*/) const { return false; }
};

/// Names of per-instance attributes (with a divisor).
using InstanceAttributes = std::set<std::string, std::less<>>;

/// A column of an instance attribute, or of a symbolic uniform (column 0 for a vector). Its components are
/// numbered among the instance's values.
struct InstanceColumn {
  std::string attribute;
  int column = 0, rows = 4;
};

/// Term of a matrix column with a product of instance attributes.
struct InstanceColumnTerm {
  uint32_t product = 0;  // of the values whose numbers, from 1, are in its bytes; 0: none
  int column = 0;
  glm::dvec4 factors{0}, magnitudes{0};  // factors of the product and of its absolute value
};

/// A component of a vertex attribute: "color", 3.
struct AttributeComponent {
  std::string attribute;  // may be "gl_Color"; empty: none
  int component = 0;
  auto operator<=>(const AttributeComponent&) const = default;
};

/// A component of a varying: constant, equal to an attribute's component, or unknown.
struct VaryingComponent {
  std::optional<double> value;
  AttributeComponent attribute;
};
/// Components of each varying, including gl_FrontColor and gl_BackColor.
using Varyings = std::map<std::string, std::vector<VaryingComponent>, std::less<>>;

/// Bounds of the alpha of all fragments that are not discarded.
struct Opacity {
  /// Alpha is at least kMin, if max(), min() and clamp() of a NaN and a number return the number.
  bool opaque = false;
  bool exact = false;                    // alpha is exactly 1
  std::vector<AttributeComponent> ones;  // condition: these are 1 at all vertices

  static constexpr double kMin = 0.999;  // stored as 255 in a byte
};

/// gl_Position = (clipFromAttribute + all terms) * attribute.
struct LinearPosition {
  std::string attribute;  // may be "gl_Vertex"
  int components = 3;     // relevant components of the attribute; the others are (0, 0, 1)
  glm::dmat4 clipFromAttribute;
  /// Upper bounds of the sums of absolute values in each element, as the scale of rounding errors.
  glm::dmat4 magnitudes;
  std::vector<InstanceColumnTerm> terms;
  std::vector<InstanceColumn> columns;  // columns whose components `terms` uses, in their order

  static constexpr size_t kNumbers = 256;
  /// Computes the matrix for these values; numbers[0] is 1. Returns false if they are too large for single
  /// precision.
  bool at(const std::array<double, kNumbers>& numbers, glm::dmat4& matrix, glm::dmat4& magnitudesThere) const;
};

/// A shader's parsed text.
class ShaderSlice {
 public:
  ~ShaderSlice();
  ShaderSlice(ShaderSlice&&) noexcept;
  ShaderSlice& operator=(ShaderSlice&&) noexcept;

 protected:
  explicit ShaderSlice(std::string_view source);
  struct Parsed;
  std::unique_ptr<const Parsed> parsed_;
};

class PositionSlice : public ShaderSlice {
 public:
  /// `source`: concatenated texts of a shader program's vertex shaders, as the host program gave them.
  explicit PositionSlice(std::string_view source) : ShaderSlice(source) {}

  /// Short reason why positions are unknown for any uniforms; empty if there is none.
  const std::string& why() const;
  /// Evaluates gl_Position for these values. Returns nullopt, and sets `why`, if it is not linear in one
  /// vertex attribute. `varyings`: receives the fragment shader's inputs.
  std::optional<LinearPosition> evaluate(const UniformSource& uniforms, std::string& why,
                                         const InstanceAttributes& instances = {},
                                         Varyings* varyings = nullptr) const;
};

class AlphaSlice : public ShaderSlice {
 public:
  /// `source`: concatenated texts of a shader program's fragment shaders, as the host program gave them.
  explicit AlphaSlice(std::string_view source) : ShaderSlice(source) {}

  /// `varyings`: outputs of the vertex shader, including "gl_Color".
  Opacity opacity(const UniformSource& uniforms, const Varyings& varyings = {}) const;

 private:
  /// `ones`: components of attributes that are assumed to be 1.
  Opacity opacity(const UniformSource& uniforms, const Varyings& varyings,
                  std::vector<AttributeComponent> ones) const;
};

}  // namespace gluray::gl
