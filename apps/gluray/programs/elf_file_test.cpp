#include "programs/elf_file.h"

#include <elf.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace gluray::launcher {
namespace {

/// A file with one segment loaded at address 0x1000, which holds the whole file: header, segments,
/// interpreter, dynamic section, strings.
std::string makeElf(const std::vector<std::string>& needed, const std::string& interpreter, bool dynamic) {
  constexpr size_t kInterpreter = 512, kDynamic = 1024, kStrings = 2048, kSize = 4096, kBase = 0x1000;
  std::string bytes(kSize, '\0');
  const auto put = [&](size_t at, const auto& value) {
    std::memcpy(bytes.data() + at, &value, sizeof value);
  };
  Elf64_Ehdr header{};
  std::memcpy(header.e_ident, ELFMAG, SELFMAG);
  header.e_ident[EI_CLASS] = ELFCLASS64, header.e_ident[EI_DATA] = ELFDATA2LSB;
  header.e_machine = EM_X86_64, header.e_phoff = sizeof header, header.e_phentsize = sizeof(Elf64_Phdr);
  std::vector<Elf64_Phdr> segments(1);
  segments[0].p_type = PT_LOAD, segments[0].p_vaddr = kBase, segments[0].p_filesz = kSize;
  const auto add = [&](uint32_t type, size_t offset, size_t size) {
    Elf64_Phdr s{};
    s.p_type = type, s.p_offset = offset, s.p_vaddr = kBase + offset, s.p_filesz = size;
    segments.push_back(s);
  };
  if (!interpreter.empty()) {
    add(PT_INTERP, kInterpreter, interpreter.size() + 1);
    bytes.replace(kInterpreter, interpreter.size(), interpreter);
  }
  if (dynamic) {
    std::vector<Elf64_Dyn> entries;
    size_t at = 1;
    for (const std::string& name : needed) {
      entries.push_back({DT_NEEDED, {at}});
      bytes.replace(kStrings + at, name.size(), name);
      at += name.size() + 1;
    }
    entries.push_back({DT_STRTAB, {kBase + kStrings}});
    entries.push_back({DT_NULL, {0}});
    for (size_t i = 0; i < entries.size(); ++i) put(kDynamic + i * sizeof(Elf64_Dyn), entries[i]);
    add(PT_DYNAMIC, kDynamic, entries.size() * sizeof(Elf64_Dyn));
  }
  header.e_phnum = static_cast<Elf64_Half>(segments.size());
  put(0, header);
  for (size_t i = 0; i < segments.size(); ++i) put(sizeof header + i * sizeof(Elf64_Phdr), segments[i]);
  return bytes;
}

TEST(ElfFile, NamesItsLoaderAndLibraries) {
  const ElfFile file = parseElf(makeElf({"libGL.so.1", "libc.so.6"}, "/lib64/ld-linux-x86-64.so.2", true));
  EXPECT_TRUE(file.elf && file.is64 && file.dynamic);
  EXPECT_EQ(file.machine, EM_X86_64);
  EXPECT_EQ(file.interpreter, "/lib64/ld-linux-x86-64.so.2");
  EXPECT_EQ(file.needed, (std::vector<std::string>{"libGL.so.1", "libc.so.6"}));
}

TEST(ElfFile, StaticProgramsHaveNeitherLoaderNorLibraries) {
  const ElfFile file = parseElf(makeElf({}, "", false));
  EXPECT_TRUE(file.elf);
  EXPECT_FALSE(file.dynamic);
  EXPECT_TRUE(file.interpreter.empty() && file.needed.empty());
}

TEST(ElfFile, OtherFilesAreNotElf) {
  EXPECT_FALSE(parseElf("").elf);
  EXPECT_FALSE(parseElf("#!/bin/sh\n").elf);
  EXPECT_FALSE(readElf("/nowhere").elf);
  EXPECT_FALSE(readElf("/").elf);
}

TEST(ElfFile, ThirtyTwoBitFilesAreRecognisedButNotRead) {
  std::string bytes = makeElf({"libGL.so.1"}, "/lib/ld-linux.so.2", true);
  bytes[EI_CLASS] = ELFCLASS32;
  const ElfFile file = parseElf(bytes);
  EXPECT_TRUE(file.elf);
  EXPECT_FALSE(file.is64);
  EXPECT_TRUE(file.needed.empty());
}

TEST(ElfFile, DamagedFilesYieldWhatIsReadable) {
  const std::string whole = makeElf({"libGL.so.1", "libX11.so.6"}, "/lib64/ld-linux-x86-64.so.2", true);
  for (size_t size = 0; size < whole.size(); size += 7) parseElf(whole.substr(0, size));
  for (size_t at = 16; at < 1200; ++at) {  // each byte of headers and dynamic section is 255 once
    std::string broken = whole;
    broken[at] = '\xff';
    for (const std::string& name : parseElf(broken).needed) EXPECT_FALSE(name.empty());
  }
}

TEST(ElfFile, ThisProgramIsElf) {
  const ElfFile file = readElf("/proc/self/exe");
  EXPECT_TRUE(file.dynamic);
  EXPECT_NE(std::find_if(file.needed.begin(), file.needed.end(),
                         [](const std::string& name) { return name.starts_with("libc.so"); }),
            file.needed.end());
}

TEST(ElfFile, StringsStandAlone) {
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / ("elf_strings" + std::to_string(getpid()));
  const auto write = [&](const std::string& text) { std::ofstream(path, std::ios::binary) << text; };
  const std::vector<std::string> words = {"libGL.so", "libEGL.so"};
  using namespace std::string_literals;
  write("\0libGL.so.1\0xlibEGL.so\0"s);
  EXPECT_EQ(stringsIn(path, words), (std::vector<std::string>{"libGL.so"}));
  write("\0/usr/lib/libEGL.so\0libGL.sound\0"s);
  EXPECT_EQ(stringsIn(path, words), (std::vector<std::string>{"libEGL.so"}));
  std::filesystem::remove(path);
  EXPECT_TRUE(stringsIn(path, words).empty());
}

}  // namespace
}  // namespace gluray::launcher
