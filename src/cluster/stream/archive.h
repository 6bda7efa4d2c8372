// Writes and reads values member by member: those of fields() (scene_fields.h), numbers, enumerations,
// vectors, arrays and optional shared values. A derived class D adds value(x) for kinds of its own.
#pragma once
#include "cluster/stream/byte_stream.h"
#include "cluster/stream/enum_ranges.h"
#include "cluster/stream/scene_fields.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace gluray::cluster {

/// Numbers, vectors and matrices: all their bits are values.
template <class T>
inline constexpr bool kIsPlain = std::is_arithmetic_v<T> && !std::is_same_v<T, bool>;
template <glm::length_t L, class T, glm::qualifier Q>
inline constexpr bool kIsPlain<glm::vec<L, T, Q>> = true;
template <glm::length_t C, glm::length_t R, class T, glm::qualifier Q>
inline constexpr bool kIsPlain<glm::mat<C, R, T, Q>> = true;

template <class D>
class WriteArchive {
 public:
  template <class... T>
  void operator()(const T&... values) {
    (static_cast<D*>(this)->value(values), ...);
  }

  template <class T>
  void value(const T& v) {
    if constexpr (kIsPlain<T> || std::is_enum_v<T>)
      out_.put(v);
    else
      fields(*static_cast<D*>(this), v);
  }
  void value(const bool& v) { out_.put(static_cast<uint8_t>(v)); }
  template <class T>
  void value(const std::vector<T>& v) {
    out_.put(static_cast<uint64_t>(v.size()));
    if constexpr (kIsPlain<T>)
      out_.put(v.data(), v.size() * sizeof(T));
    else
      for (const T& element : v) (*this)(element);
  }
  template <class T, size_t N>
  void value(const std::array<T, N>& v) {
    for (const T& element : v) (*this)(element);
  }
  template <class T>
  void value(const std::shared_ptr<const T>& v) {
    (*this)(v != nullptr);
    if (v) (*this)(*v);
  }

 protected:
  ByteWriter out_;
};

/// Throws Malformed where a value is none that WriteArchive writes.
template <class D>
class ReadArchive {
 public:
  explicit ReadArchive(std::span<const std::byte> bytes) : in_(bytes) {}

  template <class... T>
  void operator()(T&... values) {
    (static_cast<D*>(this)->value(values), ...);
  }

  template <class T>
  void value(T& v) {
    if constexpr (kIsPlain<T>) {
      v = in_.get<T>();
    } else if constexpr (std::is_enum_v<T>) {
      v = in_.get<T>();
      if (!isKnown(v)) throw Malformed("an enumeration has no such value");
    } else {
      fields(*static_cast<D*>(this), v);
    }
  }
  void value(bool& v) {
    const auto byte = in_.get<uint8_t>();
    if (byte > 1) throw Malformed("a truth value is neither 0 nor 1");
    v = byte != 0;
  }
  template <class T>
  void value(std::vector<T>& v) {
    if constexpr (kIsPlain<T>) {
      v.resize(in_.count(sizeof(T)));
      const auto bytes = in_.readBytes(v.size() * sizeof(T));
      if (!v.empty()) std::memcpy(v.data(), bytes.data(), bytes.size());
    } else {
      // An element may take far more memory than its bytes: grows as they are read.
      const size_t count = in_.count(1);
      v.clear();
      for (size_t i = 0; i < count; ++i) (*this)(v.emplace_back());
    }
  }
  template <class T, size_t N>
  void value(std::array<T, N>& v) {
    for (T& element : v) (*this)(element);
  }
  template <class T>
  void value(std::shared_ptr<const T>& v) {
    bool exists = false;
    (*this)(exists);
    if (!exists) return v.reset();
    auto made = std::make_shared<T>();
    (*this)(*made);
    v = std::move(made);
  }

 protected:
  ByteReader in_;
};

}  // namespace gluray::cluster
