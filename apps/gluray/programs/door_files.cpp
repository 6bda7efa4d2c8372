#include "programs/door_files.h"

#include "base/files.h"
#include "base/hash.h"
#include "control/runtime_directory.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace gluray::launcher {
namespace {

namespace fs = std::filesystem;

constexpr const char* kVendorFile = "/gluray_egl.json";
constexpr const char* kFolders = "doors-";  // in the private directory, one for each place of GLuRay
constexpr size_t kMax = size_t{1} << 16;    // bytes of a vendor file

/// A vendor file for the EGL door in `directory`, whose name is plain.
std::string vendorText(const std::string& directory) {
  return R"({"file_format_version": "1.0.0", "ICD": {"library_path": ")" + directory +
         R"(/libEGL_gluray.so.0"}})" + "\n";
}

/// Removes folders whose links lead nowhere: GLuRay has been moved or removed.
void removeStale(const std::string& privateDirectory) {
  std::error_code error;
  for (fs::directory_iterator entry(privateDirectory, error), end; !error && entry != end;
       entry.increment(error)) {
    const fs::path link = entry->path() / "lib";
    std::error_code ignored;
    if (entry->path().filename().string().starts_with(kFolders) && fs::is_symlink(link, ignored) &&
        !fs::exists(link, ignored))
      fs::remove_all(entry->path(), ignored);
  }
}

/// The private folder for `directory`, with a link "lib" to it; empty if it cannot be made.
std::string folderFor(const std::string& directory, std::string privateDirectory) {
  if (!isPlainName(privateDirectory) || !control::makeRuntimeDirectory(privateDirectory).empty()) return "";
  char name[32];
  const Hash128 hash = hashBytes(directory.data(), directory.size());
  std::snprintf(name, sizeof name, "/%s%016llx", kFolders, static_cast<unsigned long long>(hash.low));
  const std::string folder = std::move(privateDirectory) + name, link = folder + "/lib";
  std::error_code error;
  if (fs::read_symlink(link, error) == directory && !error) return folder;
  removeStale(fs::path(folder).parent_path());
  mkdir(folder.c_str(), 0700);
  const std::string draft = link + "." + std::to_string(getpid());
  if (symlink(directory.c_str(), draft.c_str()) != 0) return "";
  if (rename(draft.c_str(), link.c_str()) == 0) return folder;
  unlink(draft.c_str());
  return "";
}

std::string privateFolder(const std::string& directory) {
  const std::string folder = folderFor(directory, control::runtimeDirectory());
  return folder.empty() ? folderFor(directory, "/tmp/gluray-" + std::to_string(getuid())) : folder;
}

/// The vendor file that names the EGL door in `directory`. The one beside the library, if it does. Without a
/// private folder that one too: libEGL finds the library by LD_LIBRARY_PATH.
std::string vendorFileFor(const std::string& directory, const std::string& folder) {
  const std::string text = vendorText(directory), beside = directory + kVendorFile,
                    mine = folder + kVendorFile;
  if (files::read(beside, kMax).text == text || folder.empty()) return beside;
  if (files::read(mine, kMax).text == text || files::replace(mine, text).empty()) return mine;
  return beside;
}

}  // namespace

bool isPlainName(const std::string& path) {
  return path.starts_with('/') && std::none_of(path.begin(), path.end(), [](unsigned char c) {
           return c <= ' ' || c == 0x7f || c == ':' || c == ';' || c == '$' || c == '"' || c == '\\';
         });
}

DoorFiles doorFiles(const std::string& directory) {
  DoorFiles files;
  const bool plain = isPlainName(directory);
  const bool named = plain && files::read(directory + kVendorFile, kMax).text == vendorText(directory);
  const std::string folder = named ? "" : privateFolder(directory);
  if (!plain && folder.empty()) {
    files.why = "LD_LIBRARY_PATH and LD_PRELOAD cannot name " + directory +
                ", and no link to it can be made in " + control::runtimeDirectory() +
                ": move GLuRay, or set GLURAY_RUNTIME to a directory of yours";
    return files;
  }
  files.directory = plain ? directory : folder + "/lib";
  files.eglVendorFile = vendorFileFor(files.directory, folder);
  return files;
}

}  // namespace gluray::launcher
