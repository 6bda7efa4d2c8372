// Words in commands for a shell.
#pragma once
#include <string>

namespace gluray::launcher {

/// The text as one word of a shell: in quotes if it has anything but plain characters. A word that begins
/// with
/// "-" names a file in the working directory.
inline std::string shellWord(const std::string& text) {
  const char* const plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789%_-./+:@=";
  if (!text.empty() && text.find_first_not_of(plain) == text.npos && !text.starts_with('-')) return text;
  std::string quoted = text.starts_with('-') ? "'./" : "'";
  for (const char letter : text) quoted += letter == '\'' ? "'\\''" : std::string(1, letter);
  return quoted + "'";
}

}  // namespace gluray::launcher
