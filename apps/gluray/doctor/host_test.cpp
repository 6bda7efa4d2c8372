#include "doctor/host.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace gluray::launcher {
namespace {

namespace fs = std::filesystem;

Host hostWith(const char* ids) { return {ids, false, true, true}; }

TEST(DoctorHost, LibrariesAreNamedAsTheSystemNamesItsPackages) {
  const Host debian = hostWith("debian");
  EXPECT_EQ(adviceForLibrary("libembree3.so.3", debian), "sudo apt install libembree3-3");
  EXPECT_EQ(adviceForLibrary("libtbb.so.12", debian), "sudo apt install libtbb12");
  EXPECT_EQ(adviceForLibrary("libGLU.so.1", hostWith("linuxmint ubuntu debian")), "sudo apt install libglu1");
  EXPECT_EQ(adviceForLibrary("libfoo_bar.so.2", debian), "sudo apt install libfoo-bar2");
  EXPECT_EQ(adviceForLibrary("plugin.so", debian), "apt-file search plugin.so");
  EXPECT_EQ(adviceForLibrary("libGLU.so.1", hostWith("rocky rhel centos fedora")),
            "sudo dnf install 'libGLU.so.1()(64bit)'");
  EXPECT_EQ(adviceForLibrary("libGLU.so.1", hostWith("opensuse-leap suse opensuse")),
            "sudo zypper install 'libGLU.so.1()(64bit)'");
  EXPECT_EQ(adviceForLibrary("libGLU.so.1", hostWith("arch")),
            "pacman -F libGLU.so.1 names the package that has it");
}

TEST(DoctorHost, NothingIsAdvisedThatTheUserCannotDo) {
  Host host = hostWith("debian");
  host.hasSudo = false;
  EXPECT_EQ(adviceForOpenGl("glx", host),
            "ask an administrator to install libgl1 libglx-mesa0 libgl1-mesa-dri");
  EXPECT_EQ(adviceForLibrary("libGLU.so.1", host), "ask an administrator to install libglu1");
  host.isRoot = true;
  EXPECT_EQ(adviceForOpenGl("egl", host), "apt install libegl1 libegl-mesa0 libgl1-mesa-dri");
  host.hasManager = false;
  EXPECT_EQ(adviceForOpenGl("egl", host).find("apt"), std::string::npos);
  EXPECT_EQ(adviceForLibrary("libGLU.so.1", host), "install the package that has libGLU.so.1");
  EXPECT_EQ(adviceForLibrary("libGLU.so.1", hostWith("nixos")), "install the package that has libGLU.so.1");
  EXPECT_NE(adviceForOpenGl("glx", hostWith("")).find("libGL.so.1"), std::string::npos);
}

/// A folder with these files, removed at the end.
class InstalledFolder {
 public:
  explicit InstalledFolder(std::initializer_list<const char*> files) {
    char name[] = "/tmp/gluray-host-XXXXXX";
    root_ = mkdtemp(name);
    for (const char* file : files) {
      fs::create_directories((root_ / file).parent_path());
      std::ofstream(root_ / file) << "x";
    }
  }
  ~InstalledFolder() { fs::remove_all(root_); }
  std::string libraries() const { return root_ / "lib/gluray"; }
  std::string root() const { return root_; }

 private:
  fs::path root_;
};

TEST(DoctorHost, KnowsHowGlurayWasInstalled) {
  const char* const engine = "lib/gluray/libgluray-engine.so";
  const char* const substitutes = "lib/gluray/private/libgluray-substitutes.so";
  const InstalledFolder archive{engine, substitutes}, build{engine, "CMakeCache.txt"}, other{engine},
      wheel{engine, substitutes, "lib/python3.12/site-packages/gluray-0.1.0.dist-info/RECORD"},
      notWheel{engine, substitutes, "lib/python3.12/site-packages/gluray_other-1.dist-info/RECORD"};
  EXPECT_EQ(howInstalled(archive.libraries()), Installed::archive);
  EXPECT_EQ(howInstalled(build.libraries()), Installed::build);
  EXPECT_EQ(howInstalled(other.libraries()), Installed::other);
  EXPECT_EQ(howInstalled(wheel.libraries()), Installed::wheel);
  EXPECT_EQ(howInstalled(notWheel.libraries()), Installed::archive);
  EXPECT_EQ(described(Installed::wheel, wheel.libraries()), "the Python wheel in " + wheel.root());
  EXPECT_EQ(adviceToReinstall(Installed::wheel, {}), "pip install --force-reinstall --no-deps gluray");
  EXPECT_EQ(adviceToReinstall(Installed::package, {"debian", false, false, true}),
            "ask an administrator to install the package gluray again");
}

TEST(DoctorHost, RemovalIsAdvisedAsTheUserCanDoIt) {
  EXPECT_EQ(adviceToRemove(Installed::package, "/usr/lib/gluray", {"debian", true, false, true}),
            "apt purge gluray");
  EXPECT_EQ(adviceToRemove(Installed::package, "/usr/lib/gluray", {"debian", false, true, true}),
            "sudo apt purge gluray");
  EXPECT_EQ(adviceToRemove(Installed::package, "/usr/lib/gluray", {"debian", false, false, true}),
            "ask an administrator to remove the package gluray");
  EXPECT_EQ(adviceToRemove(Installed::archive, "/opt/a b/lib/gluray", {}), "rm -r '/opt/a b'");
}

TEST(DoctorHost, ThisMachineHasAName) { EXPECT_NE(thisHost().ids, ""); }

}  // namespace
}  // namespace gluray::launcher
