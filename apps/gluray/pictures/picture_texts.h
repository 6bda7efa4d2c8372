// What the files of pictures say about themselves, and commands in such texts. Any thread.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace gluray::launcher {

/// The texts of a PNG file before its pixels, by keyword (uncompressed iTXt). Throws std::runtime_error with
/// one line if it is none or cannot be read.
std::map<std::string, std::string> textsOf(const std::string& file);

/// The words of a command that shellWord() has written. None: it has anything else that means something to a
/// shell. Nothing is expanded or run.
std::optional<std::vector<std::string>> wordsOf(const std::string& command);

}  // namespace gluray::launcher
