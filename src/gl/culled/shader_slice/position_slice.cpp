#include "gl/culled/shader_slice/position_slice.h"

#include "base/ample_stack.h"
#include "gl/culled/shader_slice/slice_run.h"
#include "gl/glsl/parser/glsl_preprocessor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace gluray::gl {

struct ShaderSlice::Parsed {
  std::string source;  // the tokens point into it
  glsl::Tree tree;
  std::string why;
};

ShaderSlice::ShaderSlice(std::string_view source) {
  auto parsed = std::make_unique<Parsed>();
  parsed->source = source;
  try {
    parsed->tree = onAmpleStack([&] { return glsl::parse(preprocessed(parsed->source)); });
  } catch (const std::runtime_error& error) { parsed->why = error.what(); }
  parsed_ = std::move(parsed);
}

ShaderSlice::~ShaderSlice() = default;
ShaderSlice::ShaderSlice(ShaderSlice&&) noexcept = default;
ShaderSlice& ShaderSlice::operator=(ShaderSlice&&) noexcept = default;

bool LinearPosition::at(const std::array<double, kNumbers>& numbers, glm::dmat4& matrix,
                        glm::dmat4& magnitudesThere) const {
  constexpr double kLargestNumber = 1e9, kLargestProduct = 1e18;
  int count = 1;
  bool fits = true;
  for (const InstanceColumn& column : columns)
    for (int r = 0; r < column.rows; ++r, ++count)
      fits = fits && std::abs(numbers[static_cast<size_t>(count)]) <= kLargestNumber;
  matrix = clipFromAttribute, magnitudesThere = magnitudes;
  for (const InstanceColumnTerm& term : terms) {
    double product = 1;
    for (int shift = 0; shift < 32; shift += 8) product *= numbers[(term.product >> shift) & 0xFF];
    fits = fits && std::abs(product) <= kLargestProduct;
    matrix[term.column] += product * term.factors;
    magnitudesThere[term.column] += std::abs(product) * term.magnitudes;
  }
  // Shaders compute this matrix by more operations than a product of uniforms.
  magnitudesThere *= 2;
  return fits;
}

const std::string& PositionSlice::why() const { return parsed_->why; }

namespace {

using Factors = std::array<double, 5>;

[[noreturn]] void giveUp(const char* why) { throw std::runtime_error(why); }

/// Element `column` of a row; the last component of the attribute is 1.
double elementOf(const Factors& row, int column) {
  return row[static_cast<size_t>(column)] + (column == 3 ? row[4] : 0);
}

/// The term of `product` for a column; adds it if it is missing.
InstanceColumnTerm& termOf(LinearPosition& position, uint32_t product, int column) {
  for (InstanceColumnTerm& term : position.terms)
    if (term.product == product && term.column == column) return term;
  return position.terms.emplace_back(InstanceColumnTerm{product, column});
}

void addRow(LinearPosition& position, const glsl::Linear& l, int row) {
  for (int c = 0; c < 4; ++c) {
    position.clipFromAttribute[c][row] = elementOf(l.factors, c);
    position.magnitudes[c][row] = elementOf(l.magnitudes, c);
    for (const glsl::InstanceTerm& term : l.terms) {
      if (elementOf(term.magnitudes, c) == 0) continue;
      InstanceColumnTerm& to = termOf(position, term.product, c);
      to.factors[row] = elementOf(term.factors, c), to.magnitudes[row] = elementOf(term.magnitudes, c);
    }
  }
}

}  // namespace

std::optional<LinearPosition> PositionSlice::evaluate(const UniformSource& uniforms, std::string& why,
                                                      const InstanceAttributes& instances,
                                                      Varyings* varyings) const {
  why = parsed_->why;
  if (!why.empty()) return std::nullopt;
  try {
    glsl::SliceRun run(parsed_->tree, uniforms, glsl::SliceRun::Stage::vertex, instances);
    const glsl::Value position = run.run();
    LinearPosition result;
    int attribute = -1;
    bool usesW = false, usesOne = false;
    if (position.components.size() != 4) giveUp("gl_Position is not a vec4");
    for (int row = 0; row < 4; ++row) {
      const glsl::Linear& l = position.components[static_cast<size_t>(row)];
      if (!l.known) giveUp("gl_Position is not linear in an attribute, or not followed");
      if (l.attribute >= 0 && attribute >= 0 && l.attribute != attribute)
        giveUp("gl_Position depends on several attributes");
      if (l.attribute >= 0) attribute = l.attribute;
      usesW = usesW || l.magnitudes[3] != 0, usesOne = usesOne || l.magnitudes[4] != 0;
      for (const glsl::InstanceTerm& term : l.terms)
        usesW = usesW || term.magnitudes[3] != 0, usesOne = usesOne || term.magnitudes[4] != 0;
      addRow(result, l, row);
    }
    if (attribute < 0) giveUp("gl_Position depends on no attribute");
    if (usesW && usesOne) giveUp("gl_Position is not linear in an attribute");
    result.attribute = run.attribute(attribute);
    result.components = usesW ? 4 : std::min(3, run.componentsOf(attribute));
    result.columns = run.instanceColumns();
    if (varyings) *varyings = run.varyings();
    return result;
  } catch (const std::runtime_error& error) { why = error.what(); }
  return std::nullopt;
}

Opacity AlphaSlice::opacity(const UniformSource& uniforms, const Varyings& varyings,
                            std::vector<AttributeComponent> ones) const {
  Varyings given = varyings;
  for (auto& [name, components] : given)
    for (VaryingComponent& component : components)
      if (std::ranges::find(ones, component.attribute) != ones.end()) component.value = 1;
  Opacity result;
  try {
    glsl::SliceRun run(parsed_->tree, uniforms, glsl::SliceRun::Stage::fragment, {}, std::move(given));
    const glsl::Value color = run.run();
    if (color.shape.base != glsl::Shape::Base::floats || color.components.size() != 4) return {};
    const glsl::Linear& alpha = color.components[3];
    const glsl::Range range = rangeOf(alpha);
    result.exact = alpha.isConstant() && alpha.exact && alpha.value() == 1;
    result.opaque = result.exact || (range.number && range.low >= Opacity::kMin);
  } catch (const std::runtime_error&) { return {}; }
  if (result.opaque) result.ones = std::move(ones);
  return result;
}

Opacity AlphaSlice::opacity(const UniformSource& uniforms, const Varyings& varyings) const {
  if (!parsed_->why.empty()) return {};
  Opacity result = opacity(uniforms, varyings, {});
  if (result.opaque) return result;
  // The alpha of a vertex is a single number, or the last of four components.
  std::set<AttributeComponent> alphas;
  for (const auto& [name, components] : varyings)
    for (const VaryingComponent& component : components)
      if (!component.attribute.attribute.empty() &&
          (component.attribute.component == 3 || components.size() == 1))
        alphas.insert(component.attribute);
  for (const AttributeComponent& alpha : alphas)
    if (result = opacity(uniforms, varyings, {alpha}); result.opaque) return result;
  return alphas.size() < 2 ? result : opacity(uniforms, varyings, {alphas.begin(), alphas.end()});
}

}  // namespace gluray::gl
