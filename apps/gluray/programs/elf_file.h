// Reads the parts of an ELF file that are needed to find its libraries. Source: System V ABI, chapters 4
// and 5.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace gluray::launcher {

struct ElfFile {
  bool elf = false;                 // it is an ELF file
  bool is64 = false;                // 64 bits, little-endian; if not, the members below are unset
  int machine = 0;                  // EM_X86_64 ...
  bool dynamic = false;             // has a dynamic section
  std::string interpreter;          // the loader; empty: static, or a library
  std::vector<std::string> needed;  // libraries, in order
};

/// Reads a file; `elf` is false if it cannot be read or is no ELF file. Damaged files yield what can be read.
ElfFile readElf(const std::string& path);

/// The same from a file's bytes.
ElfFile parseElf(std::string_view bytes);

/// Those of `words` that the file holds as whole strings: preceded by a zero or a slash, and followed by a
/// zero or ".". Only a hint at what a program may open at run time.
std::vector<std::string> stringsIn(const std::string& path, const std::vector<std::string>& words);

}  // namespace gluray::launcher
