// Messages of the control protocol (docs/control-protocol.md): one JSON object per line. Any thread.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace gluray::control {

inline constexpr size_t kMaxBytes = size_t{1} << 20;  // of a message, including its line feed
inline constexpr int kMaxDepth = 16;                  // of nested arrays and objects

/// Splits a stream of bytes into lines.
class LineReader {
 public:
  /// Adds bytes. Returns false if a line is longer than kMaxBytes; nothing can be read after that.
  bool add(std::string_view bytes);
  /// The next complete line without its line feed; nullopt if more bytes are needed.
  std::optional<std::string> nextLine();
  /// Number of bytes that wait for the end of their line or for nextLine().
  size_t waiting() const { return bytes_.size() - begin_; }
  /// Number of bytes in the buffer, including read ones.
  size_t held() const { return bytes_.size(); }

 private:
  std::string bytes_;
  size_t begin_ = 0;    // start of the first unread line
  size_t scanned_ = 0;  // at least begin_; no line feed between begin_ and here
  size_t open_ = 0;     // bytes after the last line feed
  bool failed_ = false;
};

/// A message, or a one-line error message in `why`.
struct Parsed;
Parsed parse(std::string_view line);

/// Why receivers would refuse a line, which includes its line feed: it is too long or nested too deeply.
/// Empty if they would accept it.
std::string whyUnfit(std::string_view line);

/// The message as a line, including its line feed. Text that is not UTF-8 gets replacement characters.
std::string lineOf(const nlohmann::json& message);

}  // namespace gluray::control
