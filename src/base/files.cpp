#include "base/files.h"

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

namespace gluray::files {
namespace {

constexpr mode_t kMode = 0644;

std::string reason(int error) { return std::error_code(error, std::generic_category()).message(); }

/// Error for anything but a regular file; empty for a regular file.
std::string kindProblem(mode_t mode) {
  if (S_ISREG(mode)) return "";
  if (S_ISDIR(mode)) return reason(EISDIR);
  const char* kind = S_ISLNK(mode)    ? "a symbolic link"
                     : S_ISFIFO(mode) ? "a FIFO"
                     : S_ISSOCK(mode) ? "a socket"
                                      : "a device";
  return std::string("it is ") + kind + ", not a regular file";
}

/// The descriptor of the stream that `path` refers to; -1 if it is a file.
int streamOf(const std::string& path) {
  if (path == "-" || path == "/dev/stdout" || path == "/dev/fd/1" || path == "/proc/self/fd/1")
    return STDOUT_FILENO;
  if (path == "/dev/stderr" || path == "/dev/fd/2" || path == "/proc/self/fd/2") return STDERR_FILENO;
  return -1;
}

bool isNull(const std::string& path) {
  struct stat status {};
  return lstat(path.c_str(), &status) == 0 && S_ISCHR(status.st_mode) && status.st_rdev == makedev(1, 3);
}

constexpr int kPatienceMs = 1000;  // for a slow reader of a whole report

Opened opened(int descriptor, std::string path = "") {
  if (descriptor < 0) return {glurayNoOutput(), "", reason(errno)};
  return {glurayOutputOf(descriptor), std::move(path), ""};
}

Opened failed(std::string why) { return {glurayNoOutput(), "", std::move(why)}; }

Opened openedStream(int number) {
  const GlurayOutput output = stream(number);
  return output.descriptor >= 0 ? Opened{output, "", ""} : failed(reason(EBADF));
}

using Streams = std::array<GlurayOutput, 3>;  // by number; the first is not used

Streams& streams() {
  static Streams both{glurayNoOutput(), glurayStream(STDOUT_FILENO), glurayStream(STDERR_FILENO)};
  return both;
}

/// Opens the file again if its name still refers to it.
bool reopen(Opened& opened) {
  const int flags = O_WRONLY | O_APPEND | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
  const int descriptor = opened.path.empty() ? -1 : open(opened.path.c_str(), flags);
  const GlurayOutput now = glurayOutputOf(descriptor);
  const bool same =
      now.descriptor >= 0 && now.device == opened.output.device && now.inode == opened.output.inode;
  if (same)
    opened.output = now;
  else if (descriptor >= 0)
    ::close(descriptor);
  return same;
}

/// Creates a file with a new name beside `path`. Returns its descriptor and name.
std::pair<int, std::string> openDraft(const std::string& path, mode_t mode) {
  constexpr int kAttempts = 16;
  const std::string folder = path.substr(0, path.rfind('/') + 1);
  for (int i = 0;; ++i) {
    uint64_t number = 0;
    if (getrandom(&number, sizeof number, GRND_NONBLOCK) < 0)
      number = static_cast<uint64_t>(getpid()) << 32 | static_cast<uint64_t>(i);
    char name[40];
    snprintf(name, sizeof name, ".gluray-%016llx", static_cast<unsigned long long>(number));
    std::string draft = folder + name;
    const int file = open(draft.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
    if (file >= 0 || errno != EEXIST || i == kAttempts) return {file, std::move(draft)};
  }
}

/// Whether `path` may be replaced: the permissions for the new file, or an error.
std::pair<mode_t, std::string> inspect(const std::string& path) {
  struct stat status {};
  if (lstat(path.c_str(), &status) != 0) return {kMode, errno == ENOENT ? "" : reason(errno)};
  if (std::string why = kindProblem(status.st_mode); !why.empty()) return {0, std::move(why)};
  if (faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0) return {0, reason(errno)};
  return {status.st_mode & 0666, ""};
}

/// Renames a draft to `path`; removes the draft if that fails.
std::string place(const std::string& draft, const std::string& path) {
  if (rename(draft.c_str(), path.c_str()) == 0) return "";
  std::string why = reason(errno);
  unlink(draft.c_str());
  return why;
}

}  // namespace

bool isStream(const std::string& path) { return streamOf(path) >= 0 || isNull(path); }

bool isOutput(const std::string& path) { return streamOf(path) == STDOUT_FILENO; }

bool writeAll(int descriptor, std::string_view content) {
  const GlurayOutput output = glurayOutputOf(descriptor);
  int error = 0;
  glurayWrite(&output, content.data(), content.size(), kPatienceMs, &error);
  if (error != 0) errno = error;
  return error == 0;
}

bool write(Opened& opened, std::string& content, int patienceMs) {
  int error = 0;
  size_t written = glurayWrite(&opened.output, content.data(), content.size(), patienceMs, &error);
  content.erase(0, written);
  if (error == EBADF && reopen(opened)) {
    written = glurayWrite(&opened.output, content.data(), content.size(), patienceMs, &error);
    content.erase(0, written);
  }
  if (error == 0 || error == EAGAIN) return true;
  opened.why = error == EBADF ? "the program has closed it" : reason(error);
  return false;
}

void close(Opened& opened) {
  if (!opened.path.empty() && glurayIsSame(&opened.output)) ::close(opened.output.descriptor);
  opened = Opened();
}

GlurayOutput stream(int number) { return streams()[static_cast<size_t>(number)]; }

void ownStreams() {
  for (const int number : {STDOUT_FILENO, STDERR_FILENO})
    streams()[static_cast<size_t>(number)] = glurayOutputOf(number);
}

std::string replace(const std::string& path, std::string_view content) {
  if (const int number = streamOf(path); number >= 0) {
    Opened stream = openedStream(number);
    if (!stream.isOpen()) return stream.why;
    std::string left(content);
    if (!write(stream, left, kPatienceMs)) return stream.why;
    return left.empty() ? "" : "its reader is too slow";
  }
  if (isNull(path)) return "";
  Draft draft(path);
  if (draft.write(content)) draft.place();
  return draft.why();
}

Draft::Draft(const std::string& path) : path_(path) {
  if (isStream(path)) why_ = "it is not a regular file";
  if (!why_.empty()) return;
  errno = 0;
  mode_t mode = 0;
  std::tie(mode, why_) = inspect(path);
  if (!why_.empty()) {
    error_ = errno;
    return;
  }
  std::tie(file_, draft_) = openDraft(path, mode);
  if (file_ < 0) fail(errno), draft_.clear();
}

Draft::~Draft() {
  if (file_ >= 0) ::close(file_);
  if (!draft_.empty()) unlink(draft_.c_str());
}

bool Draft::fail(int error) {
  if (why_.empty()) error_ = error, why_ = reason(error);
  return false;
}

bool Draft::write(std::string_view content) {
  if (!why_.empty()) return false;
  return writeAll(file_, content) || fail(errno);
}

bool Draft::writeAt(uint64_t place, std::string_view content) {
  const bool there = why_.empty() && lseek(file_, static_cast<off_t>(place), SEEK_SET) >= 0;
  return there ? write(content) : fail(errno);
}

bool Draft::place() {
  if (!why_.empty()) return false;
  const int file = std::exchange(file_, -1);
  if (::close(file) != 0 || rename(draft_.c_str(), path_.c_str()) != 0) return fail(errno);
  draft_.clear();
  return true;
}

Opened start(const std::string& path) {
  if (const int number = streamOf(path); number >= 0) return openedStream(number);
  if (isNull(path)) return opened(open(path.c_str(), O_WRONLY | O_CLOEXEC), path);
  auto [mode, problem] = inspect(path);
  if (!problem.empty()) return failed(std::move(problem));
  const auto [file, draft] = openDraft(path, mode);
  if (file < 0) return opened(file);
  if (std::string why = place(draft, path); !why.empty()) {
    ::close(file);
    return failed(std::move(why));
  }
  return opened(file, path);
}

Opened append(const std::string& path) {
  if (const int number = streamOf(path); number >= 0) return openedStream(number);
  if (isNull(path)) return opened(open(path.c_str(), O_WRONLY | O_CLOEXEC), path);
  if (std::string problem = inspect(path).second; !problem.empty()) return failed(std::move(problem));
  const int flags = O_WRONLY | O_APPEND | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
  const int file = open(path.c_str(), flags, kMode);
  if (file < 0) return opened(file);
  struct stat status {};  // the name may refer to another file by now
  std::string problem = fstat(file, &status) != 0 ? reason(errno) : kindProblem(status.st_mode);
  if (problem.empty()) return opened(file, path);
  ::close(file);
  return failed(std::move(problem));
}

bool claim(const std::string& path) {
  const int fresh = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, kMode);
  if (fresh >= 0) ::close(fresh);
  return fresh >= 0 || errno != EEXIST;
}

std::string obstacle(const std::string& path) { return isStream(path) ? "" : inspect(path).second; }

void removeOld(const std::string& path) {
  struct stat status {};
  if (isStream(path)) return;
  if (lstat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode)) unlink(path.c_str());
}

namespace {

/// Error if anyone but the user and root owns or may write the file; empty if none.
std::string ownerProblem(const struct stat& status) {
  if (status.st_uid != 0 && status.st_uid != geteuid()) return "it belongs to another user";
  // A private group, whose number equals the user's, has no other members.
  const bool shared = status.st_gid != 0 && (status.st_gid != getegid() || getegid() != geteuid());
  if ((status.st_mode & S_IWOTH) || ((status.st_mode & S_IWGRP) && shared)) return "others may write it";
  return "";
}

Content readIf(const std::string& path, size_t mostBytes, std::string (*problem)(const struct stat&)) {
  struct stat status {};  // checked before opening, because opening some devices has effects, and after
  if (stat(path.c_str(), &status) != 0) return {"", reason(errno), errno == ENOENT};
  if (std::string why = kindProblem(status.st_mode); !why.empty()) return {"", std::move(why), false};
  const int file = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (file < 0) return {"", reason(errno), errno == ENOENT};
  Content content;
  content.why = fstat(file, &status) != 0 ? reason(errno) : kindProblem(status.st_mode);
  if (content.why.empty() && problem) content.why = problem(status);
  std::vector<char> piece(size_t{1} << 14);
  for (ssize_t bytes = 1; content.why.empty() && bytes != 0;) {
    bytes = ::read(file, piece.data(), piece.size());
    if (bytes < 0 && errno != EINTR) content.why = reason(errno);
    if (bytes > 0) content.text.append(piece.data(), static_cast<size_t>(bytes));
    if (content.text.size() > mostBytes)
      content.why = "it is larger than " + std::to_string(mostBytes) + " bytes";
  }
  ::close(file);
  if (!content.why.empty()) content.text.clear();
  return content;
}

}  // namespace

Content read(const std::string& path, size_t mostBytes) { return readIf(path, mostBytes, nullptr); }

Content readOwn(const std::string& path, size_t mostBytes) {
  struct stat link {};
  if (lstat(path.c_str(), &link) == 0 && S_ISLNK(link.st_mode) && link.st_uid != 0 &&
      link.st_uid != geteuid())
    return {"", "it is a symbolic link of another user", false};
  return readIf(path, mostBytes, ownerProblem);
}

}  // namespace gluray::files
