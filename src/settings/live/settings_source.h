// The current settings. Contexts read them once per frame, when it begins, so that a change at run time is
// one store. Also counts the frames of the process. Any thread; nothing here waits for slow operations.
#pragma once
#include "settings/settings.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>

namespace gluray {

class SettingsSource {
 public:
  using Shared = std::shared_ptr<const Settings>;
  explicit SettingsSource(const Settings& first = {}) : now_(std::make_shared<const Settings>(first)) {}

  Shared current() const {
    const std::lock_guard lock(mutex_);
    return now_;
  }
  /// Increases with every store. Frames check it first, without a lock.
  uint64_t version() const noexcept { return version_.load(std::memory_order_acquire); }

  /// Stores settings that apply at once. Drops those of storeAt(), which `settings` must include.
  void store(const Settings& settings);
  /// Stores settings that apply from a frame on, replacing earlier ones of storeAt(). Returns their ticket.
  uint64_t storeAt(uint64_t frame, const Settings& settings);
  /// Stores `now`, and replaces settings of storeAt() that do not apply yet by `later`. If they already
  /// apply, stores `later` instead.
  void storeBoth(const Settings& now, const Settings& later);

  // Frames are counted from 1, for all contexts together. A frame begins with its first clear. A frame
  // without a clear begins when the frame before it is shown.
  /// Call when a frame has been shown.
  void endFrame() noexcept;
  /// Call before a frame's first clear.
  void beginFrame() noexcept;
  /// Number of the current frame, or of the next one if none is being drawn.
  uint64_t frame() const noexcept { return frame_.load(std::memory_order_relaxed); }
  /// The last frame that has begun. Times are those of nowSeconds().
  struct Begun {
    uint64_t frame = 0;
    double began = 0, before = 0;  // when it and the previous frame began; 0: never
    double active = 0;             // when a frame last began or was shown; 0: never
  };
  Begun begun() const noexcept;
  /// Call when a frame has been shown, and before the first clear of the next one. Calls the function of
  /// watch(), then returns the settings if their version differs from `version`, and sets `version`. Null if
  /// they are unchanged.
  Shared takeNewer(uint64_t& version) noexcept;
  /// The first frame that took this version or a later one; nullopt if it has not begun.
  std::optional<uint64_t> firstFrameWith(uint64_t version) const;
  /// The first frame that took the settings of this ticket; nullopt if it has not begun.
  std::optional<uint64_t> firstFrameOfTicket(uint64_t ticket) const;
  /// Whether settings of this ticket, or later ones, apply.
  bool counts(uint64_t ticket) const;

  /// Sets a function that is called when frames begin, before they take the settings. It may store new ones.
  void watch(void (*look)() noexcept) noexcept { look_.store(look, std::memory_order_release); }

 private:
  static constexpr uint64_t kNever = std::numeric_limits<uint64_t>::max();
  static constexpr size_t kRemembered = 16;  // number of versions whose first frames are known
  struct Taken {
    uint64_t version = 0, frame = 0;
  };
  void noteBegun(uint64_t frame, double when) noexcept;
  // The following functions require the mutex.
  void publish(Shared& next) noexcept;
  void publishLater() noexcept;
  void note(uint64_t version) noexcept;
  std::optional<uint64_t> firstFrame(uint64_t version) const;

  mutable std::mutex mutex_;
  Shared now_;
  Shared later_;                                // null: none
  uint64_t laterTicket_ = 0;                    // ticket of the last storeAt()
  uint64_t countingTicket_ = 0, countsIn_ = 0;  // ticket of the settings that apply; first version with them
  std::array<Taken, kRemembered> taken_{};      // by version, newest last
  std::atomic<uint64_t> laterFrame_{kNever};    // frame from which later_ applies
  std::atomic<uint64_t> version_{1};
  std::atomic<uint64_t> frame_{1};
  std::atomic<uint64_t> begun_{0};
  std::atomic<double> began_{0}, before_{0}, ended_{0};
  std::atomic<void (*)() noexcept> look_{nullptr};
};

/// The process's source. It holds the built-in settings until the session is read. Never destroyed.
SettingsSource& settingsSource();

}  // namespace gluray
