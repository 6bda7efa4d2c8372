// What each thread does when (`--timeline FILE`). Any thread; a load of one flag where nobody asks for it.
// The file is Chrome's trace event format (JSON array of complete events, microseconds), which Perfetto and
// `gluray timeline` read; its closing bracket is optional there, so that a program that is killed leaves a
// file, too.
#pragma once
#include <atomic>
#include <cstdint>
#include <string>

namespace gluray::timeline {

inline std::atomic<bool> g_recording{false};

/// Starts recording into `file`, which is written from time to time and at exit; once in a process.
/// Complains in one line where the file cannot be written, and the program goes on.
void record(const std::string& file);
/// Writes what has been recorded so far, if it is time to. Called between batches, on the program's thread.
void writeIfDue() noexcept;
/// Writes all of it.
void write() noexcept;
/// What the calling thread is called in the file. A literal.
void nameThread(const char* name) noexcept;
/// Something that happens at one moment. A literal.
void mark(const char* name) noexcept;

/// From its making to its end the thread does this. `name` is a literal; `amount`, of triangles or bytes, is
/// left out where it is 0. With `joined`, spans of one name that follow each other closely become one.
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
