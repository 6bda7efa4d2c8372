// Arrays of exported files, read in pieces, so that geometry is written from where it lies without a copy of
// the whole. Any thread.
#pragma once
#include "scene/mesh.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace gluray::saved {

/// One element of an array, tightly packed. shorts4 and bytes4 are colours: the largest number is 1.
enum class Element : uint8_t { float2, float3, float4, bytes4, shorts4, uint32 };

constexpr size_t bytesOf(Element element) {
  switch (element) {
    case Element::float2:
    case Element::shorts4: return 8;
    case Element::float3: return 12;
    case Element::float4: return 16;
    default: return 4;
  }
}

class ArraySource {
 public:
  ArraySource(Element element, size_t count) : element_(element), count_(count) {}
  virtual ~ArraySource() = default;
  Element element() const { return element_; }
  size_t count() const { return count_; }
  size_t bytes() const { return count_ * bytesOf(element_); }
  /// Writes the elements [first, first + count) to `out`. Several threads may read at once.
  virtual void read(size_t first, size_t count, std::byte* out) const = 0;
  /// The elements in memory in this very form; null if reading converts them.
  virtual const std::byte* inPlace() const { return nullptr; }

 private:
  Element element_;
  size_t count_;
};
using SourcePtr = std::shared_ptr<const ArraySource>;

/// Reads with all threads of the second arena (parallel/arena.h).
void readAll(const ArraySource&, size_t first, size_t count, std::byte* out);

/// Calls take(bytes, size) for consecutive parts of the array; ends early, with false, where it returns
/// false.
template <class Take>
bool takePieces(const ArraySource& source, const Take& take) {
  constexpr size_t kPiece = size_t{4} << 20;
  if (const std::byte* all = source.inPlace()) {
    for (size_t at = 0; at < source.bytes(); at += kPiece)
      if (!take(all + at, std::min(kPiece, source.bytes() - at))) return false;
    return true;
  }
  const size_t each = bytesOf(source.element()), most = kPiece / each;
  std::vector<std::byte> piece(std::min(most, source.count()) * each);
  for (size_t at = 0; at < source.count(); at += most) {
    const size_t count = std::min(most, source.count() - at);
    readAll(source, at, count, piece.data());
    if (!take(piece.data(), count * each)) return false;
  }
  return true;
}

/// Elements that the source owns.
template <class T>
class OwnArray final : public ArraySource {
 public:
  OwnArray(Element element, std::vector<T> values)
      : ArraySource(element, values.size() * sizeof(T) / bytesOf(element)), values_(std::move(values)) {}
  void read(size_t first, size_t count, std::byte* out) const override {
    const size_t each = bytesOf(element());
    std::copy_n(inPlace() + first * each, count * each, out);
  }
  const std::byte* inPlace() const override { return reinterpret_cast<const std::byte*>(values_.data()); }

 private:
  std::vector<T> values_;
};

template <class T>
SourcePtr ownArray(Element element, std::vector<T> values) {
  return std::make_shared<OwnArray<T>>(element, std::move(values));
}

/// Elements of another source, each changed by a function object: Change::operator()(const From*, To*).
template <class From, class To, class Change>
class ChangedArray final : public ArraySource {
 public:
  ChangedArray(SourcePtr source, Element element, Change change)
      : ArraySource(element, source->count()), source_(std::move(source)), change_(std::move(change)) {}
  void read(size_t first, size_t count, std::byte* out) const override {
    constexpr size_t kFew = 1024;
    const size_t from = bytesOf(source_->element()), to = bytesOf(element());
    alignas(16) std::byte some[kFew * 16];
    for (size_t done = 0; done < count; done += kFew) {
      const size_t now = std::min(kFew, count - done);
      const std::byte* in = source_->inPlace();
      if (in)
        in += (first + done) * from;
      else
        source_->read(first + done, now, some), in = some;
      for (size_t i = 0; i < now; ++i)
        change_(reinterpret_cast<const From*>(in + i * from), reinterpret_cast<To*>(out + (done + i) * to));
    }
  }

 private:
  SourcePtr source_;
  Change change_;
};

template <class From, class To, class Change>
SourcePtr changedArray(SourcePtr source, Element element, Change change) {
  return std::make_shared<ChangedArray<From, To, Change>>(std::move(source), element, std::move(change));
}

}  // namespace gluray::saved
