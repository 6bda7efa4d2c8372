// Safe access to all files that GLuRay writes, and to those that it reads because a user named them. Only
// regular files are replaced, appended to or read. Directories, links, FIFOs and devices are not touched.
// "-", /dev/stdout and /dev/stderr are the process's streams; /dev/null discards. Errors are returned as one
// line, empty if there is none. Any thread.
#pragma once
#include "base/guarded_write.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace gluray::files {

/// Whether the name refers to a stream of the process or /dev/null instead of a file.
bool isStream(const std::string& path);
/// Whether the name refers to standard output.
bool isOutput(const std::string& path);

/// Replaces a file atomically: writes to an unpredictable name in the same directory, then renames. Writes
/// directly to a stream.
std::string replace(const std::string& path, std::string_view content);

/// A file that is written in parts and replaces `path` when it is complete: until place() succeeds, the old
/// file stays. Not for streams. One thread.
class Draft {
 public:
  explicit Draft(const std::string& path);
  /// Removes what place() has not put in place.
  ~Draft();
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  /// Appends to the file. Returns false after an error; then nothing more is written.
  bool write(std::string_view content);
  /// Writes at a place of the file, over what stands there; write() goes on behind it. Returns false after an
  /// error.
  bool writeAt(uint64_t place, std::string_view content);
  /// Puts the file in the place of `path`. Returns false after an error, this one's or an earlier one.
  bool place();
  /// The first error, empty if there is none.
  const std::string& why() const { return why_; }
  /// Its errno; 0 if there is none, or none from the system.
  int error() const { return error_; }

 private:
  bool fail(int error);

  std::string path_, draft_, why_;
  int file_ = -1, error_ = 0;
};

/// An output that is written over time: a stream of the process, or a file that stays open.
struct Opened {
  GlurayOutput output = glurayNoOutput();
  std::string path;  // of the file; empty for a stream
  std::string why;   // the error, if there is no descriptor
  bool isOpen() const { return output.descriptor >= 0; }
};
/// Creates an empty file, which replaces an older one, and opens it.
Opened start(const std::string& path);
/// Opens a file for appending.
Opened append(const std::string& path);
/// Writes to the output and removes the written part from `content`. Never blocks, but waits up to
/// `patienceMs` for a slow reader. Opens the file again if the host program has closed its descriptor.
/// Returns false, and sets `opened.why`, if the output can no longer be written. Returns true with content
/// left if the reader is slow.
bool write(Opened& opened, std::string& content, int patienceMs);
/// Closes a file, unless the host program has closed its descriptor.
void close(Opened& opened);
/// Writes all of `content` to a descriptor that the caller has just opened. Returns false on an error; see
/// errno.
bool writeAll(int descriptor, std::string_view content);

/// Standard output (1) or standard error (2), as defined in base/guarded_write.h. Identified at the first
/// call.
GlurayOutput stream(int number);
/// Uses the streams that the process has now, even if an outer program's launcher has passed others. Call at
/// the start of main() of our own programs.
void ownStreams();

/// Creates an empty file. Returns false if the name exists.
bool claim(const std::string& path);
/// The error that replace() or start() would return for the name, as far as it can be predicted; empty if
/// none.
std::string obstacle(const std::string& path);
/// Removes a regular file; does not touch anything else.
void removeOld(const std::string& path);

struct Content {
  std::string text;
  std::string why;       // the error, if the file was not read
  bool missing = false;  // the error is that there is no such file
};
/// Reads a file of at most `mostBytes`. Follows links.
Content read(const std::string& path, size_t mostBytes);
/// Like read(), but refuses files and links owned by anyone but root or the user, and files that others may
/// write: a file planted in a shared directory must have no effect.
Content readOwn(const std::string& path, size_t mostBytes);

}  // namespace gluray::files
