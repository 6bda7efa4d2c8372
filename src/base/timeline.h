// Records the activity of each thread over time (`--timeline FILE`), in Chrome's trace event format (JSON
// array of complete events, microseconds), which Perfetto and `gluray timeline` read. The format's closing
// bracket is optional, so the file of a killed program is valid. While off, it costs one load of a flag. Any
// thread.
#pragma once
#include <atomic>
#include <cstdint>
#include <string>

namespace gluray::timeline {

inline std::atomic<bool> g_recording{false};

/// Starts recording into `file`, which is written periodically and at exit; once per process. If the file
/// cannot be written, logs one line, and the program continues.
void record(const std::string& file);
/// Writes the events so far, if the write interval has passed. Called between batches, on the program's
/// thread.
void writeIfDue() noexcept;
/// Writes all events.
void write() noexcept;
/// Names the calling thread in the file. `name` is a literal.
void nameThread(const char* name) noexcept;
/// Records an instantaneous event. `name` is a literal.
void mark(const char* name) noexcept;

/// Records its lifetime as an event of the thread. `name` is a literal. `amount` is in triangles or bytes; 0:
/// none. `joined`: merges consecutive spans of the same name that are less than 30 microseconds apart.
class Span {
 public:
  explicit Span(const char* name, uint64_t amount = 0, bool joined = false) noexcept {
    if (!g_recording.load(std::memory_order_relaxed)) [[likely]]
      return;
    begin(name, amount, joined);
  }
  ~Span() {
    if (name_) [[unlikely]]
      end();
  }
  Span(const Span&) = delete;
  Span& operator=(const Span&) = delete;
  void setAmount(uint64_t amount) noexcept { amount_ = amount; }

 private:
  void begin(const char* name, uint64_t amount, bool joined) noexcept;
  void end() noexcept;

  const char* name_ = nullptr;  // null: not recorded
  uint64_t amount_ = 0;
  int64_t start_ = 0;  // nanoseconds
  bool joined_ = false;
};

}  // namespace gluray::timeline
