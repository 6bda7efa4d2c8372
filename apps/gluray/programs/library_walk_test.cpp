#include "programs/library_walk.h"

#include <gtest/gtest.h>

namespace gluray::launcher {
namespace {

ElfFile needing(std::vector<std::string> names) {
  ElfFile file;
  file.needed = std::move(names);
  return file;
}

/// A viewer whose library links OpenGL; the libraries have a cycle, and one is missing.
const std::map<std::string, ElfFile> kFiles = {
    {"/bin/viewer", needing({"libScene.so.1", "libc.so.6", "ld-linux-x86-64.so.2"})},
    {"/lib/libScene.so.1", needing({"libGL.so.1", "libGone.so.3", "libc.so.6"})},
    {"/lib/libGL.so.1", needing({"libGLdispatch.so.0", "libScene.so.1"})},
    {"/lib/libGLdispatch.so.0", needing({"libc.so.6"})},
    {"/lib/libc.so.6", needing({})},
};
constexpr const char* kList =
    "\tlinux-vdso.so.1 (0x00007ffd)\n"
    "\tlibScene.so.1 => /lib/libScene.so.1 (0x00007f01)\n"
    "\tlibc.so.6 => /lib/libc.so.6 (0x00007f02)\n"
    "\tlibGL.so.1 => /lib/libGL.so.1 (0x00007f03)\n"
    "\tlibGone.so.3 => not found\n"
    "\tlibGLdispatch.so.0 => /lib/libGLdispatch.so.0 (0x00007f04)\n"
    "\t/lib64/ld-linux-x86-64.so.2 (0x00007f05)\n";

std::vector<WalkedLibrary> walk() {
  return walkLibraries("/bin/viewer", pathsOf(kList),
                       [](const std::string& path) { return kFiles.at(path); });
}

TEST(LibraryWalk, PathsComeFromTheLoader) {
  const LibraryPaths paths = pathsOf(kList);
  EXPECT_EQ(paths.size(), 5u);
  EXPECT_EQ(paths.at("libGL.so.1"), "/lib/libGL.so.1");
  EXPECT_EQ(paths.at("libGone.so.3"), "");
}

TEST(LibraryWalk, VisitsLibrariesOfLibrariesOnce) {
  std::vector<std::string> names;
  for (const WalkedLibrary& library : walk()) names.push_back(library.name);
  EXPECT_EQ(names, (std::vector<std::string>{"libScene.so.1", "libc.so.6", "libGL.so.1", "libGone.so.3",
                                             "libGLdispatch.so.0"}));
}

TEST(LibraryWalk, NamesTheFileThatNeedsEachLibrary) {
  EXPECT_EQ(chainTo("libGL.so.1", walk()), "viewer > libScene.so.1 > libGL.so.1");
  EXPECT_EQ(chainTo("libc.so.6", walk()), "viewer > libc.so.6");
  EXPECT_EQ(chainTo("libElse.so", walk()), "libElse.so");
}

TEST(LibraryWalk, MissingLibrariesHaveNoPath) {
  for (const WalkedLibrary& library : walk()) EXPECT_EQ(library.path.empty(), library.name == "libGone.so.3");
}

}  // namespace
}  // namespace gluray::launcher
