#include "base/timeline.h"

#include "base/files.h"
#include "base/log.h"
#include "base/never_destroyed.h"

#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <deque>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace gluray::timeline {
namespace {

constexpr int64_t kClose = 30'000;          // nanoseconds: joined spans closer than this are merged
constexpr int64_t kInterval = 500'000'000;  // nanoseconds between two writes
constexpr size_t kMaxUnwrittenBytes = size_t{64} << 20;  // bytes
constexpr int kPatienceMs = 1000;                        // for a slow reader, when the process ends
constexpr size_t kMaxEvents = size_t{1} << 20;           // unwritten events per thread: about 40 MB

struct Event {
  const char* name;
  int64_t start, end;  // nanoseconds; equal for marks
  uint64_t amount;
  bool joined;
};

/// Events of one thread. That thread adds events; the thread that writes the file removes them.
struct Track {
  std::mutex mutex;
  std::deque<Event> events;
  const char* name = nullptr;
  bool named = false;  // the name is in the file
  pid_t thread = gettid();
  uint64_t lost = 0;
};

/// Never destroyed: threads record until the process ends.
struct Recorder {
  std::mutex mutex;  // guards the members below and the file
  std::vector<std::unique_ptr<Track>> tracks;
  std::string file;
  files::Opened output;
  std::string unwritten;  // its reader is slow
  pid_t process = 0;
  int64_t start = 0;
  std::atomic<int64_t> nextWrite{0};

  static Recorder& instance() {
    static NeverDestroyed<Recorder> recorder;
    return *recorder;
  }
};

int64_t now() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

thread_local Track* t_track = nullptr;  // never destroyed: threads record while they end

Track& trackOfThread() {
  if (!t_track) {
    auto track = std::make_unique<Track>();
    Recorder& recorder = Recorder::instance();
    const std::lock_guard lock(recorder.mutex);
    recorder.tracks.push_back(std::move(track));
    t_track = recorder.tracks.back().get();
  }
  return *t_track;
}

void add(const Event& event) noexcept {
  try {
    Track& track = trackOfThread();
    const std::lock_guard lock(track.mutex);
    Event* last = track.events.empty() ? nullptr : &track.events.back();
    if (event.joined && last && last->joined && last->name == event.name &&
        event.start - last->end < kClose) {
      last->end = event.end;
      last->amount += event.amount;
    } else if (track.events.size() < kMaxEvents) {
      track.events.push_back(event);
    } else {
      ++track.lost;
    }
  } catch (...) {  // out of memory: the timeline has a gap
  }
}

void appendEvent(std::string& out, const Recorder& recorder, const Track& track, const Event& event) {
  char line[320];
  const double start = static_cast<double>(event.start - recorder.start) / 1000;
  int length = 0;
  if (event.start == event.end)
    length = snprintf(line, sizeof line, R"({"ph":"i","s":"p","name":"%s","pid":%d,"tid":%d,"ts":%.3f)",
                      event.name, recorder.process, track.thread, start);
  else
    length = snprintf(line, sizeof line, R"({"ph":"X","name":"%s","pid":%d,"tid":%d,"ts":%.3f,"dur":%.3f)",
                      event.name, recorder.process, track.thread, start,
                      static_cast<double>(event.end - event.start) / 1000);
  out.append(line, static_cast<size_t>(length));
  if (event.amount) out.append(R"(,"args":{"n":)").append(std::to_string(event.amount)).append("}");
  out.append("},\n");
}

/// Appends a thread's events to `out` and removes them. Keeps the last span if it may still be extended.
void take(const Recorder& recorder, Track& track, bool all, std::string& out) {
  std::deque<Event> events;
  {
    const std::lock_guard lock(track.mutex);
    events.swap(track.events);
    if (!all && !events.empty() && events.back().joined) {
      track.events.push_back(events.back());
      events.pop_back();
    }
    if (!track.named && track.name) {
      track.named = true;
      out.append(R"({"ph":"M","name":"thread_name","pid":)" + std::to_string(recorder.process) +
                 R"(,"tid":)" + std::to_string(track.thread) + R"(,"args":{"name":")" + track.name +
                 "\"}},\n");
    }
  }
  for (const Event& event : events) appendEvent(out, recorder, track, event);
}

bool openFile(Recorder& recorder) {
  if (recorder.output.isOpen()) return true;
  recorder.output = files::start(recorder.file);
  recorder.unwritten = "[\n";
  return recorder.output.isOpen();
}

/// Writes `out`, as far as the file's reader accepts it. Returns false if the file can no longer be written.
bool writeOn(Recorder& recorder, const std::string& out, bool last) {
  if (!openFile(recorder)) return false;
  recorder.unwritten += out;
  if (!files::write(recorder.output, recorder.unwritten, last ? kPatienceMs : 0)) return false;
  if (recorder.unwritten.size() > kMaxUnwrittenBytes) recorder.output.why = "its reader is too slow";
  return recorder.unwritten.size() <= kMaxUnwrittenBytes;
}

void writeOut(bool all) noexcept {
  if (!g_recording) return;
  try {
    Recorder& recorder = Recorder::instance();
    const std::lock_guard lock(recorder.mutex);
    if (getpid() != recorder.process) return;  // forked: the file is the parent's
    std::string out;
    for (const std::unique_ptr<Track>& track : recorder.tracks) take(recorder, *track, all, out);
    if (out.empty() && recorder.unwritten.empty()) return;
    if (writeOn(recorder, out, all)) return;
    g_recording = false;
    log::write(log::Level::error, "cannot write the timeline " + recorder.file + ": " + recorder.output.why +
                                      "; recording ends");
  } catch (...) {  // out of memory: the timeline has a gap
  }
}

}  // namespace

void record(const std::string& file) {
  Recorder& recorder = Recorder::instance();
  {
    const std::lock_guard lock(recorder.mutex);
    recorder.file = file;
    recorder.process = getpid();
    recorder.start = now();
  }
  std::atexit([] { write(); });
  g_recording = true;
  nameThread("program");
}

void writeIfDue() noexcept {
  if (!g_recording.load(std::memory_order_relaxed)) return;
  std::atomic<int64_t>& next = Recorder::instance().nextWrite;
  const int64_t time = now();
  int64_t due = next;
  if (time < due || !next.compare_exchange_strong(due, time + kInterval)) return;
  writeOut(false);
}

void write() noexcept { writeOut(true); }

void nameThread(const char* name) noexcept {
  if (!g_recording.load(std::memory_order_relaxed)) return;
  try {
    Track& track = trackOfThread();
    const std::lock_guard lock(track.mutex);
    if (!track.name) track.name = name;
  } catch (...) {  // the thread keeps its number as name
  }
}

void mark(const char* name) noexcept {
  if (!g_recording.load(std::memory_order_relaxed)) return;
  const int64_t time = now();
  add({name, time, time, 0, false});
}

void Span::begin(const char* name, uint64_t amount, bool joined) noexcept {
  name_ = name, amount_ = amount, joined_ = joined;
  start_ = now();
}

void Span::end() noexcept { add({name_, start_, now(), amount_, joined_}); }

}  // namespace gluray::timeline
