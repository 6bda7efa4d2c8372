// Conversions of one value of each type from and to text. Private to src/settings; any thread.
#pragma once
#include "settings/rows.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gluray {

// Each returns an error message that lists the allowed values, or an empty string. On an error `value` is
// unchanged.
std::string readText(const Row& row, std::string_view text, bool& value);
std::string readText(const Row& row, std::string_view text, int& value);
std::string readText(const Row& row, std::string_view text, float& value);
std::string readText(const Row& row, std::string_view text, uint8_t& value);
std::string readText(const Row& row, std::string_view text, glm::vec3& value);
std::string readText(const Row& row, std::string_view text, std::string& value);
std::string readText(const Row& row, std::string_view text, std::vector<std::string>& value);
std::string readText(const Row& row, std::string_view text, QuirkSet& value);

std::string printText(const Row& row, bool value);
std::string printText(const Row& row, int value);
std::string printText(const Row& row, float value);
std::string printText(const Row& row, uint8_t value);
std::string printText(const Row& row, const glm::vec3& value);
std::string printText(const Row& row, const std::string& value);
std::string printText(const Row& row, const std::vector<std::string>& value);
std::string printText(const Row& row, const QuirkSet& value);

}  // namespace gluray
