#include "control/answer_reader.h"

#include "base/printable.h"
#include "control/messages/members.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <stdexcept>

namespace gluray::launcher {
namespace {

using nlohmann::json;

[[noreturn]] void refuseMember(const char* name, const char* what) {
  throw std::runtime_error(std::string("its answer cannot be read: '") + name + "' is " + what);
}

}  // namespace

AnswerReader::AnswerReader(const json& value) : value_(value) {
  if (!value.is_object()) throw std::runtime_error("its answer cannot be read: an entry is no object");
}

const json& AnswerReader::member(const char* name) const {
  const json* const found = control::member(value_, name);
  if (!found) refuseMember(name, "missing");
  return *found;
}

std::string AnswerReader::text(const char* name) const {
  const json& found = member(name);
  if (!found.is_string() && !found.is_null()) refuseMember(name, "no text");
  return found.is_null() ? "-" : printable(found.get<std::string>());
}

bool AnswerReader::flag(const char* name) const {
  const json& found = member(name);
  if (!found.is_boolean()) refuseMember(name, "neither true nor false");
  return found.get<bool>();
}

std::optional<double> AnswerReader::number(const char* name) const {
  const json& found = member(name);
  if (!found.is_number() && !found.is_null()) refuseMember(name, "no number");
  return found.is_null() ? std::nullopt : std::optional(found.get<double>());
}

std::optional<int64_t> AnswerReader::whole(const char* name) const {
  const json& found = member(name);
  const auto number = control::wholeNumber(&found, 0, control::kMaxFrame);
  if (!number && !found.is_null()) refuseMember(name, "no whole number");
  return number;
}

std::vector<double> AnswerReader::numbers(const char* name, size_t count) const {
  const json& found = member(name);
  if (found.is_null()) return {};
  std::vector<double> all;
  if (found.is_array() && found.size() == count)
    for (const json& one : found)
      if (one.is_number()) all.push_back(one.get<double>());
  if (all.size() != count) refuseMember(name, ("no list of " + std::to_string(count) + " numbers").c_str());
  return all;
}

const json& AnswerReader::list(const char* name) const {
  const json& found = member(name);
  if (!found.is_array()) refuseMember(name, "no list");
  return found;
}

std::string AnswerReader::texts(const char* name, char sign) const {
  std::string text;
  for (const json& one : list(name)) {
    if (!one.is_string()) refuseMember(name, "no list of texts");
    if (!text.empty()) text += sign;
    text += printable(one.get<std::string>());
  }
  return text.empty() ? "-" : text;
}

std::string AnswerReader::numberText(const char* name) const {
  const auto found = number(name);
  return found ? shortNumber(*found) : "-";
}

std::string AnswerReader::wholeText(const char* name) const {
  const auto found = whole(name);
  return found ? std::to_string(*found) : "-";
}

std::string AnswerReader::numbersText(const char* name, size_t count) const {
  std::string text;
  for (const double one : numbers(name, count)) {
    if (!text.empty()) text += ' ';
    text += shortNumber(one);
  }
  return text.empty() ? "-" : text;
}

std::string shortNumber(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", number == 0 ? 0.0 : number);  // not -0
  return text;
}

}  // namespace gluray::launcher
