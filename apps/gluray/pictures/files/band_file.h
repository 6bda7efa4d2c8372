// The bands of a picture that is being made, in a file: work that was interrupted goes on where it ended.
// One thread.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace gluray::launcher {

/// What the picture is made from: files of other work are begun anew.
struct BandPlan {
  uint64_t low = 0, high = 0;  // a hash of the scene and of all that was asked for
  int width = 0, height = 0, bandRows = 0;
  int pixelBytes = 4;
  bool operator==(const BandPlan&) const = default;
};

class BandFile {
 public:
  /// The number of bands, from the first on, that the file already has of this work; 0 if it is none.
  static int finishedBands(const std::string& path, uint64_t low, uint64_t high);
  /// Whether the file is one of this work, also without bands.
  static bool isOf(const std::string& path, uint64_t low, uint64_t high);
  /// Opens the file of this work, or begins one. Throws std::runtime_error with one line.
  BandFile(std::string path, const BandPlan& plan);
  ~BandFile();
  BandFile(const BandFile&) = delete;
  BandFile& operator=(const BandFile&) = delete;

  /// Adds a band, top row first. Throws std::runtime_error with one line.
  void add(int band, int rows, const void* pixels);
  /// A row of the picture, from its top. Throws std::runtime_error with one line.
  void row(int y, void* pixels) const;
  /// `Value`: what pixels consist of.
  template <class Value>
  void row(int y, std::vector<Value>& values) const {
    values.resize(rowBytes() / sizeof(Value));
    row(y, static_cast<void*>(values.data()));
  }
  const BandPlan& plan() const { return plan_; }
  void remove();

 private:
  size_t rowBytes() const { return static_cast<size_t>(plan_.width) * static_cast<size_t>(plan_.pixelBytes); }
  [[noreturn]] void fail(int error) const;

  std::string path_;
  BandPlan plan_;
  int descriptor_ = -1;
};

}  // namespace gluray::launcher
