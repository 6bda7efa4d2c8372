#include "gl/programs/family_table.h"

namespace gluray::gl {
namespace {

/// Calls add(node) for each of a list, or for the node itself.
template <class Add>
void eachOf(const toml::node& node, Add&& add) {
  const toml::array* list = node.as_array();
  if (!list) return add(node);
  for (const toml::node& item : *list) add(item);
}

}  // namespace

void FamilyTable::fail(const toml::node& at, const std::string& what) const {
  throw FamilyError(file_ + ":" + std::to_string(at.source().begin.line) + ": " + what);
}

void FamilyTable::mention(const std::string& name) {
  if (name.empty()) return;
  mentioned_.insert(name);
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

void FamilyTable::names(const char* key, std::vector<std::string>& out) {
  texts(key, out);
  for (const std::string& name : out) mention(name);
}

void FamilyTable::flag(const char* key, bool& out) {
  const toml::node* node = get(key);
  if (!node) return;
  const auto value = node->value_exact<bool>();
  if (!value) fail(*node, std::string(key) + " must be true or false");
  out = *value;
}

void FamilyTable::value(const char* key, FamilyValue& out) {
  const toml::node* node = get(key);
  if (!node) return;
  out = {};
  if (const auto uniform = node->value_exact<std::string>()) {
    out.uniform = *uniform;
    return mention(out.uniform);
  }
  eachOf(*node, [&](const toml::node& item) {
    const auto number = item.value<double>();
    if (!number) fail(item, std::string(key) + " must be a uniform's name, a number or a list of numbers");
    out.constant.push_back(static_cast<float>(*number));
  });
  if (out.constant.empty() || out.constant.size() > 4) fail(*node, std::string(key) + " has 1 to 4 numbers");
}

void FamilyTable::allKnown() const {
  for (const auto& [key, node] : *table_)
    if (!known_.contains(key.str())) fail(node, "unknown key \"" + std::string(key.str()) + "\"");
}

}  // namespace gluray::gl
