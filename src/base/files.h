// Safe file access: all files that GLuRay writes, and all that it reads because a user named them. Only
// regular files are replaced, appended to or read; directories, links, FIFOs and devices are left alone. "-",
// /dev/stdout and /dev/stderr are the process's streams; /dev/null discards. Errors are returned as one line;
// empty: none. Any thread.
#pragma once
#include "base/guarded_write.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace gluray::files {

/// Whether the name means a stream of the process or /dev/null rather than a file.
bool isStream(const std::string& path);
/// Whether it means standard output.
bool isOutput(const std::string& path);

/// Replaces a file atomically: writes to an unpredictable name in the same directory, then renames. Writes
/// directly to a stream.
std::string replace(const std::string& path, std::string_view content);

/// Something that is written over time: a stream of the process, or a file that stays open.
struct Opened {
  GlurayOutput output = glurayNoOutput();
  std::string path;  // of a file; empty: a stream
  std::string why;   // the error, if there is no descriptor
  bool isOpen() const { return output.descriptor >= 0; }
};
/// Opens a new, empty file that replaces an older one.
Opened start(const std::string& path);
/// Opens a file for appending.
Opened append(const std::string& path);
/// Writes to it and removes from `content` what was written. Never blocks, but waits up to `patienceMs` for a
/// slow reader. Opens the file again if the host program has closed its descriptor. False: the output cannot
/// be written any more; why it cannot is in `opened.why`. True with content left: the reader is slow.
bool write(Opened& opened, std::string& content, int patienceMs);
/// Closes a file, unless the host program has closed its descriptor.
void close(Opened& opened);
/// Writes all of `content` to a descriptor that the caller has just opened; false: see errno.
bool writeAll(int descriptor, std::string_view content);

/// Standard output (1) or standard error (2), as base/guarded_write.h says. Identified at the first call.
GlurayOutput stream(int number);
/// The streams are those that the process has now, whatever the launcher of an outer program said. Call this
/// at the start of main() of our own programs.
void ownStreams();

/// Creates an empty file; false if the name exists.
bool claim(const std::string& path);
/// Error that replace() or start() would return for the name, as far as known beforehand; empty: none.
std::string obstacle(const std::string& path);
/// Removes a regular file; leaves anything else.
void removeOld(const std::string& path);

struct Content {
  std::string text;
  std::string why;       // the error, if the file was not read
  bool missing = false;  // the error is that there is no such file
};
/// Reads a file of at most `mostBytes`. Follows links.
Content read(const std::string& path, size_t mostBytes);
/// The same, but refuses files and links owned by anyone but root or the user, and files that others may
/// write: a file planted in a shared directory must have no effect.
Content readOwn(const std::string& path, size_t mostBytes);

}  // namespace gluray::files
