// Files of named sections, read through memory maps: the container of saved scenes. One thread per object.
//
// A file begins with kFileMagic and a byte-order mark. Then come the contents of sections, each at a multiple
// of kAlignment and followed by at least kAlignment bytes, then the table of all sections, then a trailer
// that says where the table is. Sections may be appended: the newest table and trailer count.
#pragma once
#include "base/hash.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <unordered_set>
#include <vector>

namespace gluray::saved {

/// What a section holds; an array of a scene also has the hash of its content as its name.
enum class Kind : uint32_t { facts = 1, snapshot = 2, array = 3, picture = 4 };

struct Section {
  Kind kind{};
  uint32_t number = 0;  // of snapshots and pictures: their order
  Hash128 name;
  uint64_t offset = 0, bytes = 0;
};

/// Writes a new file under a name of its own, which finish() renames to the wanted one. Until then, and after
/// any failure, a file of that name stays as it was. Destroyed before finish(), it leaves nothing behind.
class SectionWriter {
 public:
  /// Begins a new file. why(): one line if it cannot be written.
  explicit SectionWriter(std::string path);
  /// Writes into an empty file of this user that exists: whoever asks for it has made it. Without finish(),
  /// it is empty again.
  struct Given {};
  SectionWriter(std::string path, Given);
  /// Adds sections to a whole file of this kind in place: until finish() it is not whole. Throws
  /// std::runtime_error if it is none.
  struct Append {};
  SectionWriter(std::string path, Append);
  ~SectionWriter();
  SectionWriter(const SectionWriter&) = delete;
  SectionWriter& operator=(const SectionWriter&) = delete;

  /// Adds a section. After a failure, calls do nothing.
  void add(Kind kind, uint32_t number, const Hash128& name, std::span<const std::byte> content);
  /// Adds a section of so many bytes, which `give` hands over in pieces, in order: give(write).
  using Write = std::function<void(std::span<const std::byte>)>;
  void add(Kind kind, uint32_t number, const Hash128& name, uint64_t bytes,
           const std::function<void(const Write&)>& give);
  /// Whether an array of this name was added.
  bool has(const Hash128& name) const { return arrays_.contains(name); }
  /// Writes the table and renames the file. False: why() says why, and the file does not exist.
  bool finish();
  const std::string& why() const { return why_; }
  uint64_t bytes() const { return at_; }

 private:
  void open();
  void openGiven();
  void write(const void* bytes, size_t count);
  void pad();
  void fail(const char* what, int error);

  std::string path_, part_;  // the wanted name, and that of a new file while it is written
  int descriptor_ = -1;
  bool given_ = false;
  uint64_t at_ = 0;
  std::vector<Section> sections_;
  std::unordered_set<Hash128> arrays_;
  std::string why_;
};

/// A whole file, mapped into memory. Contents live as long as anybody holds owner().
class SectionFile {
 public:
  /// Throws std::runtime_error with one line if it is none, if it is damaged, or if it cannot be read.
  explicit SectionFile(const std::string& path);

  const std::vector<Section>& sections() const { return sections_; }
  /// The content, followed by at least kAlignment readable bytes.
  std::span<const std::byte> content(const Section& section) const;
  std::shared_ptr<const void> owner() const { return map_; }

 private:
  std::shared_ptr<const std::byte> map_;
  uint64_t bytes_ = 0;
  std::vector<Section> sections_;
};

constexpr uint64_t kAlignment = 64;

}  // namespace gluray::saved
