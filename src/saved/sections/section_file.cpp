#include "saved/sections/section_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace gluray::saved {
namespace {

// As of PNG files: the bytes that break where a file is copied as text.
constexpr std::array<char, 16> kFileMagic = {'G', 'L',  'u',  'R',    'a',    'y', ' ', 's',
                                             'c', '\r', '\n', '\x1a', '\x89', 0,   0,   0};
constexpr uint32_t kByteOrder = 0x01020304, kContainer = 1;  // the version of this container

struct Head {
  std::array<char, 16> magic = kFileMagic;
  uint32_t byteOrder = kByteOrder, container = kContainer;
  std::array<uint64_t, 5> unused{};
};
static_assert(sizeof(Head) == kAlignment);

struct Entry {
  uint32_t kind, number;
  uint64_t low, high, offset, bytes;
};
static_assert(sizeof(Entry) == 40);

struct Trailer {
  uint64_t offset = 0, entries = 0;  // of the table
  std::array<uint64_t, 2> check{};   // hash of the table
  std::array<char, 16> magic = kFileMagic;
};
static_assert(sizeof(Trailer) == 48);

std::string reason(int error) { return std::generic_category().message(error); }

/// A name beside the file that no other writer uses.
std::string partOf(const std::string& path) { return path + ".part-" + std::to_string(getpid()); }

}  // namespace

SectionWriter::SectionWriter(std::string path) : path_(std::move(path)), part_(partOf(path_)) {
  open();
  const Head head;
  write(&head, sizeof head);
}

SectionWriter::SectionWriter(std::string path, Given) : path_(std::move(path)) {
  openGiven();
  const Head head;
  write(&head, sizeof head);
}

void SectionWriter::openGiven() {
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (descriptor_ < 0) return fail("cannot be written", errno);
  struct stat info {};
  given_ = ::fstat(descriptor_, &info) == 0 && S_ISREG(info.st_mode) && info.st_size == 0 &&
           info.st_uid == ::geteuid();
  if (!given_) why_ = path_ + " is no empty file of this user";
}

SectionWriter::SectionWriter(std::string path, Append) : path_(std::move(path)) {
  sections_ = SectionFile(path_).sections();
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | O_NOFOLLOW);
  struct stat info {};
  if (descriptor_ < 0 || ::fstat(descriptor_, &info) != 0) fail("cannot be written", errno);
  at_ = static_cast<uint64_t>(info.st_size);
  pad();
}

SectionWriter::~SectionWriter() {
  if (descriptor_ < 0) return;
  if (given_ && ::ftruncate(descriptor_, 0) != 0) why_ = "it cannot be emptied";
  ::close(descriptor_);
  if (!part_.empty()) ::unlink(part_.c_str());
}

void SectionWriter::open() {
  ::unlink(part_.c_str());  // of a process that was killed and had our number
  descriptor_ = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (descriptor_ < 0) fail("cannot be written", errno);
}

void SectionWriter::fail(const char* what, int error) {
  if (why_.empty()) why_ = path_ + ' ' + what + ": " + reason(error);
}

void SectionWriter::write(const void* bytes, size_t count) {
  constexpr size_t kMost = size_t{1} << 30;  // of one call: the kernel's own limit is about 2 GiB
  const auto* from = static_cast<const char*>(bytes);
  while (why_.empty() && count > 0) {
    const ssize_t done = ::write(descriptor_, from, std::min(count, kMost));
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) return fail("cannot be written", errno);
    from += done, count -= static_cast<size_t>(done), at_ += static_cast<uint64_t>(done);
  }
}

void SectionWriter::pad() {
  static constexpr std::array<char, 2 * kAlignment> kZeros{};
  write(kZeros.data(), 2 * kAlignment - at_ % kAlignment);
}

void SectionWriter::add(Kind kind, uint32_t number, const Hash128& name, std::span<const std::byte> content) {
  add(kind, number, name, content.size(), [&](const Write& write) { write(content); });
}

void SectionWriter::add(Kind kind, uint32_t number, const Hash128& name, uint64_t bytes,
                        const std::function<void(const Write&)>& give) {
  const Section section{kind, number, name, at_, bytes};
  give([this](std::span<const std::byte> piece) { write(piece.data(), piece.size()); });
  if (why_.empty() && at_ != section.offset + bytes)
    throw std::logic_error("a section has another size than it was said to have");
  pad();
  sections_.push_back(section);
  if (kind == Kind::array) arrays_.insert(name);
}

bool SectionWriter::finish() {
  std::vector<Entry> table;
  for (const Section& s : sections_)
    table.push_back({static_cast<uint32_t>(s.kind), s.number, s.name.low, s.name.high, s.offset, s.bytes});
  const size_t bytes = table.size() * sizeof(Entry);
  const Hash128 hash = hashBytes(table.data(), bytes);
  const Trailer trailer{at_, table.size(), {hash.low, hash.high}};
  write(table.data(), bytes);
  write(&trailer, sizeof trailer);
  if (descriptor_ < 0) return false;
  if (given_ && !why_.empty()) return false;  // emptied where it is destroyed
  // Some file systems tell only now that the disk is full.
  if (::close(std::exchange(descriptor_, -1)) != 0) fail("cannot be written", errno);
  if (part_.empty()) return why_.empty();
  if (why_.empty() && ::rename(part_.c_str(), path_.c_str()) != 0) fail("cannot be replaced", errno);
  if (!why_.empty()) ::unlink(part_.c_str());
  return why_.empty();
}

SectionFile::SectionFile(const std::string& path) {
  const auto refuse = [&](const std::string& why) { throw std::runtime_error(path + ": " + why); };
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) refuse(reason(errno));
  struct stat info {};
  const bool isFile = ::fstat(descriptor, &info) == 0 && S_ISREG(info.st_mode);
  bytes_ = isFile ? static_cast<uint64_t>(info.st_size) : 0;
  void* const map = bytes_ > 0 ? ::mmap(nullptr, bytes_, PROT_READ, MAP_PRIVATE, descriptor, 0) : MAP_FAILED;
  const int error = errno;
  ::close(descriptor);
  if (!isFile || bytes_ == 0) refuse("it is no saved scene");
  if (map == MAP_FAILED) refuse(reason(error));
  map_ = {static_cast<const std::byte*>(map),
          [bytes = bytes_](const std::byte* at) { ::munmap(const_cast<std::byte*>(at), bytes); }};

  Head head;
  Trailer trailer;
  if (bytes_ < sizeof head + sizeof trailer) refuse("it is no saved scene");
  std::memcpy(&head, map_.get(), sizeof head);
  std::memcpy(&trailer, map_.get() + bytes_ - sizeof trailer, sizeof trailer);
  if (head.magic != kFileMagic) refuse("it is no saved scene");
  if (head.byteOrder != kByteOrder) refuse("it was saved on a machine with another byte order");
  if (head.container != kContainer) refuse("a newer GLuRay has saved it: use that one, or a newer one");
  const uint64_t end = bytes_ - sizeof trailer;
  const bool whole = trailer.magic == kFileMagic && trailer.offset <= end &&
                     trailer.entries == (end - trailer.offset) / sizeof(Entry) &&
                     (end - trailer.offset) % sizeof(Entry) == 0;
  if (!whole) refuse("it is not whole: save the scene again");
  std::vector<Entry> table(trailer.entries);
  if (!table.empty()) std::memcpy(table.data(), map_.get() + trailer.offset, table.size() * sizeof(Entry));
  const Hash128 hash = hashBytes(table.data(), table.size() * sizeof(Entry));
  if (hash.low != trailer.check[0] || hash.high != trailer.check[1]) refuse("it is damaged: save it again");
  for (const Entry& e : table) {
    const bool inside = e.offset % kAlignment == 0 && e.offset >= sizeof head && e.offset <= trailer.offset &&
                        e.bytes <= trailer.offset - e.offset &&
                        trailer.offset - e.offset - e.bytes >= kAlignment;
    if (!inside) refuse("it is damaged: save it again");
    sections_.push_back({static_cast<Kind>(e.kind), e.number, {e.low, e.high}, e.offset, e.bytes});
  }
}

std::span<const std::byte> SectionFile::content(const Section& section) const {
  return {map_.get() + section.offset, section.bytes};
}

}  // namespace gluray::saved
