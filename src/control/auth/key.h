// Keys and proofs of the control protocol (docs/control-protocol.md, Authentication). Any thread.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace gluray::control {

using Key = std::array<unsigned char, 32>;

/// The key in a file, or a one-line error message that says how to fix the file.
struct KeyOrWhy {
  Key key{};
  std::string why;
};
/// Reads a key file. It must be a regular file of at least 32 bytes that belongs to the user and that nobody
/// else can read or write.
KeyOrWhy readKey(const std::string& path);

/// Writes a new key file: 32 random bytes as hexadecimal digits, mode 0600. Never replaces a file. Returns an
/// error message; empty on success.
std::string writeNewKey(const std::string& path);

/// 32 random bytes as 64 hexadecimal digits; empty if no random numbers are available.
std::string newNonce();
bool isNonce(std::string_view text);

/// The side that proves that it knows the key.
enum class Prover { peer, hub };
/// The message authentication code, as 64 hexadecimal digits.
std::string proofOf(const Key& key, Prover prover, std::string_view hubNonce, std::string_view peerNonce);
/// Compares in constant time.
bool sameProof(std::string_view a, std::string_view b);

}  // namespace gluray::control
