// Messages of the control protocol (docs/control-protocol.md): one JSON object a line. Any thread.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace gluray::control {

inline constexpr size_t kMaxBytes = size_t{1} << 20;  // of a message, with its line feed
inline constexpr int kMaxDepth = 16;                  // of arrays and objects in each other

/// Splits a stream of bytes into lines.
class LineReader {
 public:
  /// Adds bytes. False: a line is longer than kMaxBytes; nothing can be read from then on.
  bool add(std::string_view bytes);
  /// The next whole line without its line feed; none: more bytes are needed.
  std::optional<std::string> nextLine();
  /// Bytes that wait for the end of their line or for nextLine().
  size_t waiting() const { return bytes_.size() - begin_; }
  /// Bytes that it holds, read ones included.
  size_t held() const { return bytes_.size(); }

 private:
  std::string bytes_;
  size_t begin_ = 0;    // of the first line that was not read
  size_t scanned_ = 0;  // at least begin_; no line feed between begin_ and here
  size_t open_ = 0;     // bytes after the last line feed
  bool failed_ = false;
};

/// A message, or in `why` one line that says what is wrong with it.
struct Parsed;
Parsed parse(std::string_view line);

/// Why receivers would not take a line, with its line feed: it is too long or nested too deep. Empty: they
/// would.
std::string whyUnfit(std::string_view line);

/// The message as a line, with its line feed. Text that is not UTF-8 gets replacement characters.
std::string lineOf(const nlohmann::json& message);

}  // namespace gluray::control
