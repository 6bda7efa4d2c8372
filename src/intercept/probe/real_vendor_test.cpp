#include "intercept/probe/real_vendor.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace gluray::probe {
namespace {

/// A folder with the given files; the destructor deletes it.
class Folder {
 public:
  Folder() : path_(std::filesystem::temp_directory_path() / ("gluray_vendors_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
    return path_ / name;
  }
  std::string path() const { return path_; }

 private:
  std::filesystem::path path_;
};

const char* const kGood = R"({"file_format_version": "1.0.0", "ICD": {"library_path": "libEGL_a.so.0"}})";
const char* const kOther =
    R"({"file_format_version": "1.0.0", "ICD": {"library_path": "/opt/libEGL_b.so.0"}})";

TEST(EglVendorLibraries, DirectoryIsReadInOrderOfNames) {
  const Folder folder;
  folder.write("50_other.json", kOther);
  folder.write("10_good.json", kGood);
  folder.write("readme.txt", kGood);
  EXPECT_EQ(eglVendorLibraries("", folder.path()), "libEGL_a.so.0:/opt/libEGL_b.so.0");
}

TEST(EglVendorLibraries, FileNamesComeBeforeDirectories) {
  const Folder folder;
  folder.write("10_good.json", kGood);
  EXPECT_EQ(eglVendorLibraries(folder.write("x.json", kOther), folder.path()), "/opt/libEGL_b.so.0");
}

TEST(EglVendorLibraries, BrokenFilesAreSkipped) {
  const Folder folder;
  folder.write("1.json", "{");
  folder.write("2.json", "[]");
  folder.write("3.json", R"({"ICD": 3})");
  folder.write("4.json", R"({"ICD": {"library_path": 7}})");
  folder.write("5.json", "");
  folder.write("6.json", kGood);
  EXPECT_EQ(eglVendorLibraries("", folder.path()), "libEGL_a.so.0");
  EXPECT_EQ(eglVendorLibraries("/nowhere.json", ""), "");
  EXPECT_EQ(eglVendorLibraries("", "/nowhere"), "");
}

TEST(FindRealVendors, EarlierChoiceIsKept) {
  setenv("__GLX_VENDOR_LIBRARY_NAME", "mesa", 1);
  EXPECT_EQ(findRealVendors().glx, "mesa");
  setenv("__GLX_VENDOR_LIBRARY_NAME", "gluray", 1);
  setenv("GLURAY_REAL_GLX", "mesa", 1);
  EXPECT_EQ(findRealVendors().glx, "mesa");
}

}  // namespace
}  // namespace gluray::probe
