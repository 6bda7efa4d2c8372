#include "gl/families/files/family_table.h"

#include "gl/families/components.h"

#include <algorithm>

namespace gluray::gl {
namespace {

constexpr std::string_view kTimes = " * ";  // between the names of a product

/// Calls add() for each node of a list, or for `node` itself.
template <class Add>
void eachOf(const toml::node& node, Add&& add) {
  const toml::array* list = node.as_array();
  if (!list) return add(node);
  for (const toml::node& item : *list) add(item);
}

}  // namespace

void FamilyTable::fail(const toml::node& at, const std::string& what) const {
  throw FamilyError(placeOf(at) + ": " + what);
}

std::string FamilyTable::placeOf(const toml::node& node) const {
  return file_ + ":" + std::to_string(node.source().begin.line);
}

void FamilyTable::mention(const std::string& name) {
  if (name.empty()) return;
  mentioned_.insert(name);
  if (componentIn(name) >= 0) mention(name.substr(0, name.size() - 2));
  if (name.ends_with(".{}")) mention(name.substr(0, name.size() - 3));
  if (name.ends_with("[{}]")) mentioned_.insert(name.substr(0, name.size() - 4));
}

const toml::node* FamilyTable::get(const char* key) {
  known_.insert(key);
  return table_->get(key);
}

void FamilyTable::text(const char* key, std::string& out) {
  const toml::node* node = get(key);
  if (!node) return;
  const auto value = node->value_exact<std::string>();
  if (!value) fail(*node, std::string(key) + " must be a text in quotes");
  out = *value;
}

void FamilyTable::texts(const char* key, std::vector<std::string>& out) {
  const toml::node* node = get(key);
  if (!node) return;
  out.clear();
  eachOf(*node, [&](const toml::node& item) {
    const auto value = item.value_exact<std::string>();
    if (!value) fail(item, std::string(key) + " must be texts in quotes");
    out.push_back(*value);
  });
}

/// The name or, for a list, its first name; the others become its alternatives.
std::string FamilyTable::nameIn(const char* key, const toml::node& node) {
  std::vector<std::string> names;
  eachOf(node, [&](const toml::node& item) {
    const auto one = item.value_exact<std::string>();
    if (!one) fail(item, std::string(key) + " must be a name in quotes, or a list of such names");
    names.push_back(*one);
  });
  if (names.empty()) return "";
  mention(names.front());
  const auto numbered = [](const std::string& name) { return name.find("{}") != std::string::npos; };
  if (names.size() > 1 && std::any_of(names.begin(), names.end(), numbered))
    fail(node, std::string(key) + ": names with {} have no alternatives");
  for (size_t i = 1; i < names.size(); ++i) {
    std::vector<std::string>& others = alternatives_[names.front()];
    if (std::find(others.begin(), others.end(), names[i]) == others.end()) others.push_back(names[i]);
  }
  return names.front();
}

void FamilyTable::name(const char* key, std::string& out) {
  if (const toml::node* node = get(key)) out = nameIn(key, *node);
}

void FamilyTable::names(const char* key, std::vector<std::string>& out) {
  const toml::node* node = get(key);
  if (!node) return;
  out.clear();
  eachOf(*node, [&](const toml::node& item) { out.push_back(nameIn(key, item)); });
}

void FamilyTable::flag(const char* key, bool& out) {
  const toml::node* node = get(key);
  if (!node) return;
  const auto value = node->value_exact<bool>();
  if (!value) fail(*node, std::string(key) + " must be true or false");
  out = *value;
}

void FamilyTable::value(const char* key, FamilyValue& out) {
  if (const toml::node* node = get(key)) out = valueIn(key, *node);
}

/// The product of several names.
FamilyValue FamilyTable::productIn(std::string_view text) {
  FamilyValue value;
  for (size_t end = 0; end != std::string_view::npos; text.remove_prefix(end + kTimes.size())) {
    end = text.find(kTimes);
    std::string name(text.substr(0, end));
    mention(name);
    (value.uniform.empty() ? value.uniform : value.factors.emplace_back()) = std::move(name);
    if (end == std::string_view::npos) break;
  }
  return value;
}

FamilyValue FamilyTable::valueIn(const char* key, const toml::node& node) {
  FamilyValue value;
  const toml::array* list = node.as_array();
  if (const auto text = node.value_exact<std::string>(); text && text->find(kTimes) != std::string::npos)
    return productIn(*text);
  if (list ? !list->empty() && list->front().is_string() : node.is_string())
    value.uniform = nameIn(key, node);
  else
    value.constant = numbersIn(key, node, 4);
  return value;
}

void FamilyTable::lightValues(const char* key, std::vector<FamilyValue>& out) {
  const toml::node* node = get(key);
  if (!node) return;
  out.clear();
  eachOf(*node, [&](const toml::node& item) { out.push_back(valueIn(key, item)); });
  if (out.empty()) fail(*node, std::string(key) + " needs a value");
}

void FamilyTable::flagOrName(const char* key, bool& flag, std::string& name) {
  const toml::node* node = get(key);
  if (!node) return;
  flag = false, name.clear();
  if (const auto value = node->value_exact<bool>())
    flag = *value;
  else
    name = nameIn(key, *node);
}

void FamilyTable::eachValue(const char* key, std::vector<FamilyValue>& out) {
  const toml::node* node = get(key);
  if (!node) return;
  out.clear();
  eachOf(*node, [&](const toml::node& item) {
    FamilyValue& value = out.emplace_back();
    if (item.is_string()) {
      value.uniform = nameIn(key, item);
      mention(value.uniform.substr(0, value.uniform.rfind('[')));  // of an array element: mentions the array
    } else {
      value.constant = numbersIn(key, item, 1);
    }
  });
}

void FamilyTable::values(const char* key, FamilyValue (&out)[3]) {
  const toml::node* node = get(key);
  if (!node) return;
  std::vector<FamilyValue> found;
  eachValue(key, found);
  if (found.size() != 1 && found.size() != 3)
    fail(*node, std::string(key) + " must have one or three values");
  for (size_t i = 0; i < 3; ++i) out[i] = found[found.size() == 1 ? 0 : i];
}

std::vector<float> FamilyTable::numbersIn(const char* key, const toml::node& node, size_t most) {
  std::vector<float> numbers;
  eachOf(node, [&](const toml::node& item) {
    const auto number = item.value<double>();
    if (!number) fail(item, std::string(key) + " must be a uniform's name, a number or a list of numbers");
    numbers.push_back(static_cast<float>(*number));
  });
  if (numbers.empty() || numbers.size() > most)
    fail(node, std::string(key) + " must have 1 to " + std::to_string(most) + " numbers");
  return numbers;
}

void FamilyTable::neutralValues(const char* key, NeutralValues& out) {
  const toml::node* node = get(key);
  if (!node) return;
  if (!node->is_table()) fail(*node, std::string(key) + " must be a section");
  for (const auto& [name, value] : *node->as_table()) {
    const std::string uniform(name.str());
    mention(uniform);
    if (value.value_exact<std::string>() == "identity")
      out[uniform].clear();
    else if (value.is_string())
      fail(value, uniform + " must be \"identity\", a number or a list of numbers");
    else
      out[uniform] = numbersIn(uniform.c_str(), value, 16);
  }
}

void FamilyTable::decidedValues(const char* key, DecidedValues& out) {
  const toml::node* node = get(key);
  if (!node) return;
  if (!node->is_table()) fail(*node, std::string(key) + " must be a section");
  out.clear();
  for (const auto& [name, value] : *node->as_table()) {
    const auto number = value.value<double>();
    if (!number) fail(value, std::string(name.str()) + " must be a number");
    mention(std::string(name.str()));
    out[std::string(name.str())] = static_cast<float>(*number);
  }
}

std::vector<std::string> FamilyTable::keys() const {
  std::vector<std::string> all;
  for (const auto& [key, node] : *table_) all.emplace_back(key.str());
  return all;
}

void FamilyTable::allKnown() const {
  for (const auto& [key, node] : *table_)
    if (!known_.contains(key.str())) fail(node, "unknown key \"" + std::string(key.str()) + "\"");
}

}  // namespace gluray::gl
