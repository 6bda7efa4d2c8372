// What an ELF file says of itself, as far as finding its libraries goes. Source: System V ABI, chapters 4
// and 5.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace gluray::launcher {

struct ElfFile {
  bool elf = false;                 // it is one
  bool is64 = false;                // of 64 bits, low byte first; all that follows is known of such only
  int machine = 0;                  // EM_X86_64 ...
  bool dynamic = false;             // has a dynamic section
  std::string interpreter;          // the loader; empty: static, or a library
  std::vector<std::string> needed;  // libraries, in order
};

/// Reads a file; elf is false where it cannot be read or is none. Damaged files yield what can be made out.
ElfFile readElf(const std::string& path);

/// The same from a file's bytes.
ElfFile parseElf(std::string_view bytes);

/// Those of `words` that stand in the file as strings of their own: preceded by a zero or a slash, and
/// followed by a zero or ".". A hint of what a program may open at run time, no more.
std::vector<std::string> stringsIn(const std::string& path, const std::vector<std::string>& words);

}  // namespace gluray::launcher
