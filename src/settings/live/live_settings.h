// The settings of this process while it runs: its layers, read again when one of their files changes, and
// values that are set live. Any thread.
#pragma once
#include "base/clock.h"
#include "settings/layers/settings_layers.h"
#include "settings/live/settings_source.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace gluray {

class LiveSettings {
 public:
  /// New settings go to `source`; lines for the user to `complain`. Both must outlive this.
  LiveSettings(SettingsSource& source, Complain complain) : source_(source), complain_(std::move(complain)) {}

  /// Reads all layers.
  Session start(Sources sources);

  /// Reads the files again if one has changed. Cheap: looks at most every kLookSeconds, less often where
  /// files are slow. If a file has a new mistake, all settings stay as they are until it is corrected.
  void readIfChanged(double now = nowSeconds()) noexcept;

  /// A value that is set live; none: the other layers count again.
  struct Change {
    std::string name;
    std::optional<std::string> value;
  };
  using Changes = std::vector<Change>;
  struct Answer {
    std::string why;       // error: nothing has changed; empty: done
    uint64_t version = 0;  // of the source, from which on the change counts
    uint64_t ticket = 0;   // of the source, if the change waits for a frame; version is 0 then
    Changes before;        // what undoes the change, in its order
  };
  /// Makes all changes, or none if one is wrong. They count from the process's frame number `frame`, or from
  /// the next one if it has begun; so do changes that waited for another frame. Throws std::bad_alloc.
  Answer change(std::span<const Change> changes, uint64_t frame = 0);
  /// Why change() would refuse; empty: it would not.
  std::string whyNot(std::span<const Change> changes);
  /// The first frame of the process with the change that was answered so; none: it has not begun.
  std::optional<uint64_t> firstFrameWith(const Answer& answer) const;

  /// What a setting is and where it comes from.
  struct Value {
    const Row* row;
    std::string text;  // as printValue() gives it
    Layer layer;
    std::string place;  // as in Given; empty: built in
    bool operator==(const Value&) const = default;
  };
  /// All settings that may stand in files. `waiting`: with changes that wait for a frame.
  std::vector<Value> values(bool waiting = false);
  /// What all layers say.
  Layers layers(bool waiting = false);
  /// Increases whenever values() may have changed.
  uint64_t revision() noexcept;

  static constexpr double kLookSeconds = 0.05;

 private:
  /// What tells that a file has changed; rights and owner change the second time.
  struct Stamp {
    int64_t device = 0, inode = 0, size = -1;   // size -1: there is none
    int64_t modified[2] = {}, changed[2] = {};  // seconds, nanoseconds
    bool operator==(const Stamp&) const = default;
    static Stamp stampOf(const std::string& file);
  };
  using Stamps = std::array<Stamp, 3>;
  using Lines = std::vector<std::string>;
  Stamps stamps() const;
  bool settled(const Stamps& now) const;
  bool isNew(const std::string& mistake) const;
  Session takeSession(Session session);
  struct Next;
  Next settingsAfter(std::span<const Change> changes) const;
  void settle();
  Settings withThreads(Settings settings) const;

  SettingsSource& source_;
  const Complain complain_;
  std::mutex mutex_;  // of what follows
  Sources sources_;
  std::optional<Sources> later_;  // with changes that wait for a frame
  uint64_t ticket_ = 0;           // of these, in source_
  std::atomic<uint64_t> revision_{0};
  int ownThreads_ = 0;  // for `threads` = 0
  ConfigFiles files_;   // as they were read last without a new mistake
  Lines mistakes_;      // in them, without numbers of lines
  bool started_ = false;
  Stamps read_, seen_;  // of the files that were read last; when readIfChanged() looked last
  double next_ = 0;     // seconds: no look before
};

}  // namespace gluray
