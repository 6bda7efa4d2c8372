#include "pictures/picture_texts.h"

#include "base/printable.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <stdexcept>

namespace gluray::launcher {
namespace {

constexpr uint32_t kMostText = 1 << 20;

uint32_t bigEndian(const char* bytes) {
  uint32_t number = 0;
  for (int i = 0; i < 4; ++i) number = number << 8 | static_cast<uint8_t>(bytes[i]);
  return number;
}

/// "Keyword", 0, whether it is compressed, how, "language", 0, "translated keyword", 0, text.
void addText(const std::string& chunk, std::map<std::string, std::string>& texts) {
  const size_t keyword = chunk.find('\0');
  if (keyword == chunk.npos || keyword + 2 >= chunk.size() || chunk[keyword + 1] != 0) return;
  const size_t language = chunk.find('\0', keyword + 3);
  const size_t translated = language == chunk.npos ? language : chunk.find('\0', language + 1);
  if (translated != chunk.npos) texts.emplace(chunk.substr(0, keyword), chunk.substr(translated + 1));
}

}  // namespace

std::map<std::string, std::string> textsOf(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  const auto fail = [&](const char* why) { throw std::runtime_error(printable(file) + ": " + why); };
  if (!in) fail("it cannot be read");
  std::array<char, 8> head{};
  in.read(head.data(), head.size());
  if (std::string(head.data(), head.size()) != "\x89PNG\r\n\x1a\n") fail("it is no PNG file");
  std::map<std::string, std::string> texts;
  for (;;) {
    in.read(head.data(), head.size());
    const uint32_t size = bigEndian(head.data());
    const std::string kind(head.data() + 4, 4);
    if (!in || kind == "IDAT" || kind == "IEND") return texts;
    if (kind == "iTXt" && size <= kMostText) {
      std::string chunk(size, 0);
      in.read(chunk.data(), size);
      if (in) addText(chunk, texts);
      in.ignore(4);  // its checksum
    } else {
      in.ignore(static_cast<std::streamsize>(size) + 4);
    }
  }
}

std::optional<std::vector<std::string>> wordsOf(const std::string& command) {
  const char* const plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789%_-./+:@=";
  std::vector<std::string> words;
  bool within = false;  // a word
  for (size_t i = 0; i < command.size(); ++i) {
    const char letter = command[i];
    if (letter == ' ') {
      within = false;
      continue;
    }
    if (!within) words.emplace_back(), within = true;
    if (letter == '\'') {
      const size_t end = command.find('\'', i + 1);
      if (end == command.npos) return std::nullopt;
      words.back() += command.substr(i + 1, end - i - 1);
      i = end;
    } else if (letter == '\\' && i + 1 < command.size() && command[i + 1] == '\'') {
      words.back() += command[++i];
    } else if (std::string(plain).find(letter) != std::string::npos) {
      words.back() += letter;
    } else {
      return std::nullopt;
    }
  }
  return words;
}

}  // namespace gluray::launcher
