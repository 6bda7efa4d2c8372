// Resolves expressions of a shader to the storage that they refer to: variables, elements, fields and
// components.
#include "gl/culled/shader_slice/slice_functions.h"
#include "gl/culled/shader_slice/slice_run.h"

#include <utility>

namespace gluray::gl::glsl {

void SliceRun::store(const Expression& target, const Value& value) {
  const std::optional<Place> place = placeOf(target);
  if (!place) {
    // The element or the variable's part is unknown: forgets the whole variable.
    std::set<std::string_view> names;
    const Expression* of = &target;
    while (of->kind == Expression::Kind::index || of->kind == Expression::Kind::member)
      of = of->parts[0].get();
    if (of->kind == Expression::Kind::name) names.insert(of->text);
    return forget(names);
  }
  if (place->components.empty()) {
    Value& to = *place->value;
    if (value.components.size() == to.components.size() && !to.components.empty())
      to.components = value.components;
    else if (value.items.size() == to.items.size() && !to.items.empty() && value.structure == to.structure)
      to = value;
    else
      to.forget();
    return;
  }
  for (size_t i = 0; i < place->components.size(); ++i) {
    const bool fits = value.components.size() == place->components.size();
    place->value->components[place->components[i]] = fits ? value.components[i] : Linear::unknown();
  }
}

std::optional<SliceRun::Place> SliceRun::placeOf(const Expression& e) {
  using Kind = Expression::Kind;
  if (e.kind == Kind::name) {
    Value* const value = find(e.text);
    return value ? std::optional(Place{value, {}}) : std::nullopt;  // else a built-in output
  }
  if (e.kind != Kind::index && e.kind != Kind::member) return std::nullopt;
  std::optional<Place> of = placeOf(*e.parts[0]);
  if (!of) return std::nullopt;
  Value& value = *of->value;
  std::vector<size_t> all = of->components;
  if (all.empty())
    for (size_t i = 0; i < value.components.size(); ++i) all.push_back(i);
  if (e.kind == Kind::member) {
    if (!value.items.empty()) {
      const Struct* const structure = structNamed(value.structure);
      for (size_t i = 0; structure && i < structure->fields.size(); ++i)
        if (structure->fields[i].name == e.text) return Place{&value.items[i], {}};
      return std::nullopt;
    }
    const std::vector<size_t> chosen = swizzled(e.text, all.size());
    if (chosen.empty() || value.shape.isMatrix())
      return chosen.empty() || all.size() > 4 ? std::nullopt : std::optional<Place>();
    Place place{&value, {}};
    for (const size_t i : chosen) place.components.push_back(all[i]);
    return place;
  }
  const std::optional<long> at = integerOf(evaluate(*e.parts[1]));
  if (!at || *at < 0) return std::nullopt;
  const auto i = static_cast<size_t>(*at);
  if (value.isArray) return i < value.items.size() ? std::optional(Place{&value.items[i], {}}) : std::nullopt;
  if (value.shape.isMatrix() && of->components.empty()) {
    if (i >= static_cast<size_t>(value.shape.columns)) return std::nullopt;
    Place place{&value, {}};
    for (int r = 0; r < value.shape.rows; ++r)
      place.components.push_back(i * static_cast<size_t>(value.shape.rows) + static_cast<size_t>(r));
    return place;
  }
  return i < all.size() ? std::optional(Place{&value, {all[i]}}) : std::nullopt;
}

bool SliceRun::uniformPath(const Expression& e, std::string& path, TypeName& type, size_t& dimension) {
  using Kind = Expression::Kind;
  tick();
  if (e.kind == Kind::name) {
    if (find(e.text)) return false;  // a local variable hides it
    const auto uniform = uniformGlobals_.find(e.text);
    if (uniform == uniformGlobals_.end()) return false;
    path = uniform->second->path, type = uniform->second->variable.type, dimension = 0;
    return true;
  }
  if (e.kind != Kind::index && e.kind != Kind::member) return false;
  if (!uniformPath(*e.parts[0], path, type, dimension)) return false;
  if (e.kind == Kind::index) {
    if (dimension >= type.sizes.size()) return false;
    const std::optional<long> at = integerOf(evaluate(*e.parts[1]));
    if (!at || *at < 0) return false;
    path.append("[").append(std::to_string(*at)).append("]"), ++dimension;
    return true;
  }
  const Struct* const structure = dimension == type.sizes.size() ? structNamed(type.name) : nullptr;
  if (!structure) return false;
  for (const Variable& field : structure->fields)
    if (field.name == e.text) {
      path.append(".").append(field.name), type = field.type, dimension = 0;
      return true;
    }
  return false;
}

std::optional<Value> SliceRun::uniformAt(const Expression& e) {
  std::string path;
  TypeName type;
  size_t dimension = 0;
  if (!uniformPath(e, path, type, dimension)) return std::nullopt;
  return uniformValue(path, type, dimension, 0);
}

Value SliceRun::index(const Expression& e) {
  if (std::optional<Value> uniform = uniformAt(e)) return *uniform;
  const Value of = evaluate(*e.parts[0]);
  const std::optional<long> at = integerOf(evaluate(*e.parts[1]));
  if (of.isArray) {
    if (of.items.empty()) return {};
    if (at && *at >= 0 && static_cast<size_t>(*at) < of.items.size())
      return of.items[static_cast<size_t>(*at)];
    Value v = of.items[0];
    v.forget();
    return v;
  }
  if (of.components.empty()) return {};
  const int size = of.shape.isMatrix() ? of.shape.rows : 1;
  const int count = of.shape.isMatrix() ? of.shape.columns : of.shape.rows;
  Value v = Value::unknown({of.shape.base, 1, size});
  if (!at || *at < 0 || *at >= count) return v;
  for (int i = 0; i < size; ++i)
    v.components[static_cast<size_t>(i)] =
        of.components[static_cast<size_t>(static_cast<int>(*at) * size + i)];
  return v;
}

Value SliceRun::member(const Expression& e) {
  if (std::optional<Value> uniform = uniformAt(e)) return *uniform;
  const Value of = evaluate(*e.parts[0]);
  if (!of.items.empty()) {
    const Struct* const structure = structNamed(of.structure);
    for (size_t i = 0; structure && i < structure->fields.size() && i < of.items.size(); ++i)
      if (structure->fields[i].name == e.text) return of.items[i];
    return {};
  }
  if (of.components.empty() || of.shape.isMatrix()) return {};
  const std::vector<size_t> chosen = swizzled(e.text, of.components.size());
  if (chosen.empty()) return {};
  Value v;
  v.shape = {of.shape.base, 1, static_cast<int>(chosen.size())};
  for (const size_t i : chosen) v.components.push_back(of.components[i]);
  return v;
}

}  // namespace gluray::gl::glsl
