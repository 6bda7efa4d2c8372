#include "control/auth/key.h"

#include "base/files.h"

#include <fcntl.h>
#include <sodium.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

namespace gluray::control {
namespace {

static_assert(std::tuple_size_v<Key> == crypto_auth_hmacsha256_KEYBYTES);
static_assert(std::tuple_size_v<Key> == crypto_hash_sha256_BYTES);

constexpr size_t kNonceBytes = 32, kMinKeyBytes = 32, kMaxKeyBytes = size_t{1} << 20;

std::string systemReason() { return std::error_code(errno, std::generic_category()).message(); }

std::string hexOf(const unsigned char* bytes, size_t count) {
  std::string text(2 * count + 1, '\0');
  sodium_bin2hex(text.data(), text.size(), bytes, count);
  text.pop_back();
  return text;
}

/// Why an open key file is refused; empty if it is valid.
std::string mistakeOf(int file, const std::string& path) {
  struct stat status {};
  if (fstat(file, &status) != 0) return path + ": " + systemReason();
  if (!S_ISREG(status.st_mode)) return path + " is no regular file; gluray hub --new-key FILE writes a key";
  if (status.st_uid != geteuid()) return path + " belongs to another user; use a copy of your own";
  if ((status.st_mode & 077) != 0) return path + " can be used by others; run chmod 600 " + path;
  if (status.st_size < static_cast<off_t>(kMinKeyBytes))
    return path + " is shorter than 32 bytes; gluray hub --new-key FILE writes a key";
  if (status.st_size > static_cast<off_t>(kMaxKeyBytes)) return path + " is longer than 1 MiB: it is no key";
  return "";
}

/// The file's bytes; empty if it cannot be read.
std::string bytesOf(int file) {
  std::string bytes(kMaxKeyBytes + 1, '\0');
  size_t size = 0;
  while (size < bytes.size()) {
    const ssize_t got = read(file, bytes.data() + size, bytes.size() - size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return "";
    if (got == 0) break;
    size += static_cast<size_t>(got);
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace

KeyOrWhy readKey(const std::string& path) {
  KeyOrWhy result;
  if (path.empty()) return result.why = "TCP needs a key file; gluray hub --new-key FILE writes one", result;
  if (sodium_init() < 0) return result.why = "this machine gives no random numbers", result;
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (file < 0) {
    const bool missing = errno == ENOENT;
    result.why = path + ": " + systemReason();
    if (missing) result.why += "; gluray hub --new-key " + path + " writes a key";
    return result;
  }
  result.why = mistakeOf(file, path);
  if (result.why.empty()) {
    std::string bytes = bytesOf(file);
    if (bytes.size() < kMinKeyBytes || bytes.size() > kMaxKeyBytes) result.why = path + " cannot be read";
    crypto_hash_sha256(result.key.data(), reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
    sodium_memzero(bytes.data(), bytes.size());
  }
  close(file);
  return result;
}

std::string writeNewKey(const std::string& path) {
  const std::string digits = newNonce();
  if (digits.empty()) return "this machine gives no random numbers";
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0600);
  if (file < 0) return path + ": " + systemReason() + (errno == EEXIST ? "; use another name" : "");
  std::string why;
  if (fchmod(file, 0600) != 0 || !files::writeAll(file, digits + "\n")) why = path + ": " + systemReason();
  if (close(file) != 0 && why.empty()) why = path + ": " + systemReason();
  if (!why.empty()) unlink(path.c_str());
  return why;
}

std::string newNonce() {
  if (sodium_init() < 0) return "";
  std::array<unsigned char, kNonceBytes> bytes{};
  randombytes_buf(bytes.data(), bytes.size());
  return hexOf(bytes.data(), bytes.size());
}

bool isNonce(std::string_view text) {
  return text.size() == 2 * kNonceBytes && text.find_first_not_of("0123456789abcdef") == text.npos;
}

std::string proofOf(const Key& key, Prover prover, std::string_view hubNonce, std::string_view peerNonce) {
  std::string text = prover == Prover::peer ? "gluray 1 peer " : "gluray 1 hub ";
  text.append(hubNonce).append(peerNonce);
  std::array<unsigned char, crypto_auth_hmacsha256_BYTES> mac{};
  crypto_auth_hmacsha256(mac.data(), reinterpret_cast<const unsigned char*>(text.data()), text.size(),
                         key.data());
  return hexOf(mac.data(), mac.size());
}

bool sameProof(std::string_view a, std::string_view b) {
  return a.size() == b.size() && sodium_memcmp(a.data(), b.data(), a.size()) == 0;
}

}  // namespace gluray::control
