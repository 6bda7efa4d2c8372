// Decides if-statements whose conditions follow from known values, for families with match.decided. Any
// thread.
#pragma once
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace gluray::gl {

/// Values of variables of a shader program, by name.
using DecidedValues = std::map<std::string, float, std::less<>>;

/// A shader's text without comments, in which each if-statement of main whose condition follows from `values`
/// is replaced by the branch that is taken, without its braces, or by nothing. Conditions compare the
/// variables with numbers and with each other, by ==, !=, <, <=, > and >=, and join comparisons by &&, || and
/// !; parts that contain anything else are not known. The other statements stay as they are.
std::string decideBranches(std::string_view text, const DecidedValues& values);

}  // namespace gluray::gl
