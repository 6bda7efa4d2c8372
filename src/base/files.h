// Every file that GLuRay writes, and every one that it reads because a user named it, goes through here.
// Nothing but regular files is replaced, appended to or read: no directory, link, FIFO or device is removed,
// followed, waited for or written into. "-", /dev/stdout and /dev/stderr are the streams of the process,
// /dev/null takes what it is given. Errors are a line for people; empty: none. Any thread.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace gluray::files {

/// Whether the name means a stream of the process, or nothing at all, rather than a file.
bool isStream(const std::string& path);
/// Whether it means standard output.
bool isOutput(const std::string& path);

/// Writes a whole file. Readers never see half of it: it is written under a name that nobody can foresee, in
/// the same directory, and renamed. To a stream it is written as it is.
std::string replace(const std::string& path, std::string_view content);

/// A descriptor to write to, which its taker closes where it is above 2.
struct Opened {
  int descriptor = -1;
  std::string why;  // where the descriptor is -1
};
/// Opens an empty file in the place of an older one.
Opened start(const std::string& path);
/// Opens a file to write behind what it holds.
Opened append(const std::string& path);
/// Writes all of it; false: errno says why not.
bool writeAll(int descriptor, std::string_view content);

/// Makes the file, empty, where nothing has that name; false where something has.
bool claim(const std::string& path);
/// Whether the name can be given to replace() and start(), as far as can be told beforehand.
std::string obstacle(const std::string& path);
/// Removes a regular file; leaves anything else.
void removeOld(const std::string& path);

struct Content {
  std::string text;
  std::string why;       // not read: why
  bool missing = false;  // because there is no such file
};
/// Reads a file of at most `mostBytes`. Links are followed.
Content read(const std::string& path, size_t mostBytes);
/// The same, but not of files, or through links, that somebody other than root or the user owns, and not of
/// files that others may write: what is planted in a shared directory is not ours to obey.
Content readOwn(const std::string& path, size_t mostBytes);

}  // namespace gluray::files
