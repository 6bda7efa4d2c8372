// Writes and reads the plain values of messages, in this machine's byte order, which the handshake checks to
// be equal at both ends. Any thread.
#pragma once
#include <cstddef>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace gluray::cluster {

/// An invalid message.
class Malformed : public std::runtime_error {
 public:
  explicit Malformed(const std::string& what) : std::runtime_error("malformed message: " + what) {}
};

class ByteWriter {
 public:
  void put(const void* bytes, size_t size);
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void put(const T& value) { put(&value, sizeof value); }
  const std::vector<std::byte>& bytes() const { return bytes_; }
  std::vector<std::byte> takeBytes() { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
};

/// Throws Malformed if a message ends too early.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) : bytes_(bytes) {}
  std::span<const std::byte> readBytes(size_t size);
  template <class T>
  requires std::is_trivially_copyable_v<T> T get() {
    T value;
    std::memcpy(&value, readBytes(sizeof value).data(), sizeof value);
    return value;
  }
  /// Reads the number of following elements of at least `least` bytes each. Rejects lists that are longer
  /// than the rest of the message before memory is allocated.
  size_t count(size_t least);
  size_t left() const { return bytes_.size(); }

 private:
  std::span<const std::byte> bytes_;
};

}  // namespace gluray::cluster
