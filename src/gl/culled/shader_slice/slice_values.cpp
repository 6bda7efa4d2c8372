// Initial values of a shader's variables: globals, attributes, uniforms.
#include "gl/culled/shader_slice/slice_functions.h"
#include "gl/culled/shader_slice/slice_run.h"

#include <algorithm>

namespace gluray::gl::glsl {
namespace {

using Base = Shape::Base;

constexpr size_t kMaxElements = 4096;
constexpr size_t kDrawBuffers = 8;

}  // namespace

void SliceRun::declareGlobals() {
  using Storage = Global::Storage;
  const Value fourFloats = Value::unknown({Base::floats, 1, 4});
  if (stage_ == Stage::vertex) {
    for (const char* const name : {"gl_Position", "gl_FrontColor", "gl_BackColor"})
      globals_[name] = fourFloats;
  } else {
    globals_["gl_FragColor"] = fourFloats, globals_["gl_Color"] = varyingValue("gl_Color", fourFloats);
    Value& data = globals_["gl_FragData"];
    data.isArray = true, data.items.assign(kDrawBuffers, fourFloats);
  }
  for (const Global& global : tree_.globals) {
    const std::string_view name = global.variable.name;
    if (global.storage == Storage::uniform)
      uniformGlobals_[name] = &global;
    else if (global.storage == Storage::attribute && stage_ == Stage::vertex)
      globals_[name] = attributeValue(global);
    else if (stage_ == Stage::fragment &&
             (global.storage == Storage::attribute || global.storage == Storage::varying))
      globals_[name] = varyingValue(name, defaultValue(global.variable.type));
    else if (global.variable.value && global.storage != Storage::other)
      globals_[name] = evaluate(*global.variable.value);
    else
      globals_[name] = defaultValue(global.variable.type);
  }
}

Value SliceRun::attributeValue(const Global& global) {
  const Shape shape = shapeOfType(global.variable.type.name);
  Value v = defaultValue(global.variable.type);
  if (shape.base != Base::floats || v.components.empty()) return v;
  const std::string name(global.variable.name);
  if (instances_.contains(name)) return instanceValue(name, shape);
  if (shape.isMatrix()) return v;
  attributes_.push_back({name, shape.rows});
  for (int i = 0; i < shape.rows; ++i) {
    Linear l;
    l.attribute = static_cast<int>(attributes_.size()) - 1, l.exact = false;
    l.factors[static_cast<size_t>(i)] = l.magnitudes[static_cast<size_t>(i)] = 1;
    v.components[static_cast<size_t>(i)] = l;
  }
  return v;
}

Value SliceRun::instanceValue(const std::string& name, const Shape& shape) {
  constexpr int kMaxNumbers = 255;
  Value v = Value::unknown(shape);
  if (instanceNumbers_ + shape.size() > kMaxNumbers) return v;
  for (int c = 0; c < shape.columns; ++c) instanceColumns_.push_back({name, c, shape.rows});
  for (Linear& l : v.components) l = Linear::ofInstance(++instanceNumbers_);
  return v;
}

/// Sets the components of `unknown` that are equal at all vertices. Interpolation may round them.
Value SliceRun::varyingValue(std::string_view name, Value unknown) const {
  const auto found = varyings_.find(name);
  if (found == varyings_.end() || found->second.size() != unknown.components.size()) return unknown;
  for (size_t i = 0; i < unknown.components.size(); ++i)
    if (const VaryingComponent& component = found->second[i]; component.value)
      unknown.components[i] = Linear::constant(*component.value, false);
  return unknown;
}

Varyings SliceRun::varyings() const {
  Varyings all;
  const auto add = [&](std::string_view name, std::string_view as) {
    const Value& value = globals_.find(name)->second;
    if (value.shape.base != Base::floats || value.shape.isMatrix() || value.components.empty()) return;
    std::vector<VaryingComponent>& components = all[std::string(as)];
    for (const Linear& l : value.components) components.push_back(varyingComponent(l));
  };
  for (const Global& global : tree_.globals)
    if (global.storage == Global::Storage::varying || global.storage == Global::Storage::output)
      add(global.variable.name, global.variable.name);
  add("gl_FrontColor", "gl_FrontColor"), add("gl_BackColor", "gl_BackColor");
  return all;
}

VaryingComponent SliceRun::varyingComponent(const Linear& l) const {
  VaryingComponent made;
  if (l.isConstant()) {
    made.value = l.value();
  } else if (l.known && l.attribute >= 0 && l.terms.empty()) {
    int component = -1;
    for (int i = 0; i < 5; ++i) {
      if (l.factors[static_cast<size_t>(i)] == 0) continue;
      if (component >= 0 || l.factors[static_cast<size_t>(i)] != 1) return made;
      component = i;
    }
    if (component >= 0 && component < 4) made.attribute = {attribute(l.attribute), component};
  }
  return made;
}

const Struct* SliceRun::structNamed(std::string_view name) const {
  const auto found = std::ranges::find_if(tree_.structs, [&](const Struct& s) { return s.name == name; });
  return found == tree_.structs.end() ? nullptr : &*found;
}

std::optional<size_t> SliceRun::sizeOf(const TypeName& type, size_t dimension) {
  if (!type.sizes[dimension]) return std::nullopt;
  const std::optional<long> size = integerOf(evaluate(*type.sizes[dimension]));
  if (!size || *size < 1 || *size > static_cast<long>(kMaxElements)) return std::nullopt;
  return static_cast<size_t>(*size);
}

Value SliceRun::defaultValue(const TypeName& type, size_t dimension, int depth) {
  if (depth > 8) return {};
  tick();
  if (dimension < type.sizes.size()) {
    const std::optional<size_t> size = sizeOf(type, dimension);
    if (!size) return {};
    Value array;
    array.isArray = true;
    for (size_t i = 0; i < *size; ++i) array.items.push_back(defaultValue(type, dimension + 1, depth + 1));
    return array;
  }
  const Struct* const structure = structNamed(type.name);
  if (!structure) return Value::unknown(shapeOfType(type.name));
  Value v;
  v.structure = structure->name;
  for (const Variable& field : structure->fields) v.items.push_back(defaultValue(field.type, 0, depth + 1));
  return v;
}

Value SliceRun::uniformValue(const std::string& path, const TypeName& type, size_t dimension, int depth) {
  tick();
  if (depth > 8) return {};
  if (dimension < type.sizes.size()) {
    const std::optional<size_t> size = sizeOf(type, dimension);
    if (!size) return {};
    Value array;
    array.isArray = true;
    for (size_t i = 0; i < *size; ++i)
      array.items.push_back(
          uniformValue(path + "[" + std::to_string(i) + "]", type, dimension + 1, depth + 1));
    return array;
  }
  if (const Struct* const structure = structNamed(type.name)) {
    Value v;
    v.structure = structure->name;
    for (const Variable& field : structure->fields)
      v.items.push_back(uniformValue(path + "." + std::string(field.name), field.type, 0, depth + 1));
    return v;
  }
  const auto known = read_.find(path);
  if (known != read_.end()) return known->second;
  const Shape shape = shapeOfType(type.name);
  Value v = Value::unknown(shape);
  if (shape.base == Base::floats && uniforms_.isSymbolic(path))
    return read_[path] = instanceValue(path, shape);
  std::vector<double> components;
  if (!v.components.empty() && uniforms_.read(path, components) && components.size() == v.components.size())
    for (size_t i = 0; i < components.size(); ++i) v.components[i] = Linear::constant(components[i]);
  return read_[path] = v;
}

}  // namespace gluray::gl::glsl
