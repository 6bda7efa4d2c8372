#include "programs/elf_file.h"

#include <elf.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstring>
#include <optional>

namespace gluray::launcher {
namespace {

/// A file mapped into memory; empty if it is not a readable regular file.
class MappedFile {
 public:
  explicit MappedFile(const std::string& path) {
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    struct stat status {};
    if (file >= 0 && fstat(file, &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0) {
      void* start = mmap(nullptr, static_cast<size_t>(status.st_size), PROT_READ, MAP_PRIVATE, file, 0);
      if (start != MAP_FAILED)
        bytes_ = {static_cast<const char*>(start), static_cast<size_t>(status.st_size)};
    }
    if (file >= 0) close(file);
  }
  ~MappedFile() {
    if (!bytes_.empty()) munmap(const_cast<char*>(bytes_.data()), bytes_.size());
  }
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;
  std::string_view bytes() const { return bytes_; }

 private:
  std::string_view bytes_;
};

template <class T>
std::optional<T> load(std::string_view bytes, uint64_t offset) {
  if (offset > bytes.size() || bytes.size() - offset < sizeof(T)) return std::nullopt;
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

/// The string that starts at `offset`, up to its zero.
std::string stringAt(std::string_view bytes, uint64_t offset) {
  if (offset >= bytes.size()) return "";
  const std::string_view rest = bytes.substr(offset);
  return std::string(rest.substr(0, rest.find('\0')));
}

std::vector<Elf64_Phdr> segments(std::string_view bytes, const Elf64_Ehdr& header) {
  std::vector<Elf64_Phdr> list;
  for (unsigned i = 0; i < header.e_phnum; ++i)
    if (const auto s = load<Elf64_Phdr>(bytes, header.e_phoff + uint64_t{i} * header.e_phentsize))
      list.push_back(*s);
  return list;
}

/// File offset of the loaded address `address`; UINT64_MAX if no segment holds it.
uint64_t fileOffset(const std::vector<Elf64_Phdr>& list, uint64_t address) {
  for (const Elf64_Phdr& s : list)
    if (s.p_type == PT_LOAD && address >= s.p_vaddr && address - s.p_vaddr < s.p_filesz)
      return s.p_offset + (address - s.p_vaddr);
  return UINT64_MAX;
}

std::vector<std::string> neededBy(std::string_view bytes, const std::vector<Elf64_Phdr>& list,
                                  const Elf64_Phdr& dynamic) {
  uint64_t strings = UINT64_MAX;
  std::vector<uint64_t> names;
  for (uint64_t at = 0; at + sizeof(Elf64_Dyn) <= dynamic.p_filesz; at += sizeof(Elf64_Dyn)) {
    const auto entry = load<Elf64_Dyn>(bytes, dynamic.p_offset + at);
    if (!entry || entry->d_tag == DT_NULL) break;
    if (entry->d_tag == DT_STRTAB) strings = fileOffset(list, entry->d_un.d_ptr);
    if (entry->d_tag == DT_NEEDED) names.push_back(entry->d_un.d_val);
  }
  std::vector<std::string> needed;
  for (const uint64_t name : names)
    if (strings < bytes.size() && name < bytes.size())
      if (std::string text = stringAt(bytes, strings + name); !text.empty())
        needed.push_back(std::move(text));
  return needed;
}

}  // namespace

ElfFile parseElf(std::string_view bytes) {
  ElfFile file;
  if (bytes.size() < EI_NIDENT || std::memcmp(bytes.data(), ELFMAG, SELFMAG) != 0) return file;
  file.elf = true;
  file.is64 = bytes[EI_CLASS] == ELFCLASS64 && bytes[EI_DATA] == ELFDATA2LSB;
  const auto header = load<Elf64_Ehdr>(bytes, 0);
  if (!file.is64 || !header) return file;
  file.machine = header->e_machine;
  const std::vector<Elf64_Phdr> list = segments(bytes, *header);
  for (const Elf64_Phdr& s : list) {
    if (s.p_type == PT_INTERP) file.interpreter = stringAt(bytes, s.p_offset);
    if (s.p_type != PT_DYNAMIC) continue;
    file.dynamic = true;
    file.needed = neededBy(bytes, list, s);
  }
  return file;
}

ElfFile readElf(const std::string& path) { return parseElf(MappedFile(path).bytes()); }

std::vector<std::string> stringsIn(const std::string& path, const std::vector<std::string>& words) {
  const MappedFile file(path);
  const std::string_view bytes = file.bytes();
  const auto standsAlone = [&](size_t at, size_t length) {
    const char before = at ? bytes[at - 1] : '\0',
               after = at + length < bytes.size() ? bytes[at + length] : '\0';
    return (before == '\0' || before == '/') && (after == '\0' || after == '.');
  };
  std::vector<std::string> found;
  for (const std::string& word : words)
    for (size_t at = bytes.find(word); at != bytes.npos; at = bytes.find(word, at + 1))
      if (standsAlone(at, word.size())) {
        found.push_back(word);
        break;
      }
  return found;
}

}  // namespace gluray::launcher
