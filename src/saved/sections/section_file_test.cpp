// The container of saved scenes: what is written is read; what is damaged is refused; old files stay.
#include "saved/sections/section_file.h"

#include "base/testing/temporary_folder.h"
#include "saved/sections/saved_picture.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace gluray::saved {
namespace {

using gluray::test::TemporaryFolder;

std::span<const std::byte> bytesOf(const std::string& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}
std::string textOf(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::vector<std::string> filesIn(const gluray::test::TemporaryFolder& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    names.push_back(entry.path().filename().string());
  return names;
}

struct SectionFiles : testing::Test {
  TemporaryFolder folder;
  const std::string path = folder.file("scene.gluray");

  void write(const std::vector<std::string>& contents) const {
    SectionWriter out(path);
    uint32_t number = 0;
    for (const std::string& content : contents) {
      ++number;
      out.add(Kind::array, number - 1, {number, 7}, bytesOf(content));
    }
    ASSERT_TRUE(out.finish()) << out.why();
  }
  std::string whyRefused() const {
    try {
      const SectionFile file(path);
      return "";
    } catch (const std::runtime_error& e) { return e.what(); }
  }
};

TEST_F(SectionFiles, AreReadAsTheyWereWritten) {
  const std::vector<std::string> contents = {"", "a", std::string(64, 'b'), std::string(100000, 'c')};
  write(contents);
  EXPECT_EQ(filesIn(folder), std::vector<std::string>{"scene.gluray"});
  const SectionFile file(path);
  ASSERT_EQ(file.sections().size(), contents.size());
  for (size_t i = 0; i < contents.size(); ++i) {
    const Section& section = file.sections()[i];
    EXPECT_EQ(section.kind, Kind::array);
    EXPECT_EQ(section.number, i);
    EXPECT_EQ(section.name, (Hash128{i + 1, 7}));
    EXPECT_EQ(section.offset % kAlignment, 0u);
    const auto content = file.content(section);
    EXPECT_EQ(textOf(content), contents[i]);
    std::byte behind[kAlignment];
    std::memcpy(behind, content.data() + content.size(), sizeof behind);  // readable
  }
}

TEST_F(SectionFiles, AreWrittenIntoEmptyFilesThatWereGiven) {
  folder.write("scene.gluray", "");
  {
    SectionWriter given_up(path, SectionWriter::Given{});
    given_up.add(Kind::facts, 0, {}, bytesOf("given up"));
  }
  EXPECT_EQ(gluray::test::textOf(folder.file("scene.gluray")), "");
  SectionWriter out(path, SectionWriter::Given{});
  out.add(Kind::facts, 0, {}, bytesOf("facts"));
  ASSERT_TRUE(out.finish()) << out.why();
  EXPECT_EQ(textOf(SectionFile(path).content(SectionFile(path).sections()[0])), "facts");
  SectionWriter full(path, SectionWriter::Given{});
  EXPECT_FALSE(full.finish());
  EXPECT_EQ(SectionFile(path).sections().size(), 1u) << "of a file with content nothing changes";
  SectionWriter missing(folder.file("missing"), SectionWriter::Given{});
  EXPECT_FALSE(missing.finish());
  EXPECT_EQ(filesIn(folder), std::vector<std::string>{"scene.gluray"});
}

TEST_F(SectionFiles, ContentsOutliveTheFileObject) {
  write({"content"});
  auto file = std::make_unique<SectionFile>(path);
  const auto owner = file->owner();
  const auto content = file->content(file->sections()[0]);
  file.reset();
  EXPECT_EQ(textOf(content), "content");
}

TEST_F(SectionFiles, TakeFurtherSections) {
  write({"one"});
  ASSERT_EQ(appendPicture(path, {2, 1, {0xff112233, 0x44556677}}), "");
  const SectionFile file(path);
  ASSERT_EQ(file.sections().size(), 2u);
  EXPECT_EQ(textOf(file.content(file.sections()[0])), "one");
  const SavedPicture picture = pictureIn(file.content(file.sections()[1]));
  EXPECT_EQ(picture.width, 2);
  EXPECT_EQ(picture.height, 1);
  EXPECT_EQ(picture.pixels, (std::vector<uint32_t>{0xff112233, 0x44556677}));
}

TEST_F(SectionFiles, ArePicturesOnlyInTheirSize) {
  EXPECT_THROW(pictureIn(bytesOf("short")), std::runtime_error);
  EXPECT_THROW(pictureIn(bytesOf(std::string(20, '\1'))), std::runtime_error);
}

TEST_F(SectionFiles, AreRefusedWhereTheyAreDamaged) {
  write({"first", std::string(500, 'x')});
  const std::string whole = gluray::test::textOf(folder.file("scene.gluray"));
  for (const size_t length : {size_t{0}, size_t{10}, size_t{70}, whole.size() / 2, whole.size() - 1}) {
    folder.write("scene.gluray", whole.substr(0, length));
    EXPECT_NE(whyRefused(), "") << length;
  }
  for (size_t at = whole.size() - 128; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x41);
    folder.write("scene.gluray", damaged);
    EXPECT_NE(whyRefused(), "") << "the table, byte " << at << " of " << whole.size();
  }
  std::string other = whole;
  other[16] = 1;  // of the byte order
  folder.write("scene.gluray", other);
  EXPECT_NE(whyRefused().find("byte order"), std::string::npos);
  folder.write("scene.gluray", "\x89PNG\r\n");
  EXPECT_NE(whyRefused().find("no saved scene"), std::string::npos);
  folder.write("scene.gluray", whole);
  EXPECT_EQ(whyRefused(), "");
}

TEST_F(SectionFiles, AreFilesOnly) {
  EXPECT_THROW(SectionFile(folder.path().string()), std::runtime_error);
  EXPECT_THROW(SectionFile(folder.file("missing")), std::runtime_error);
}

TEST_F(SectionFiles, LeaveTheOldFileWhereTheyCannotBeWritten) {
  folder.write("scene.gluray", "old");
  {
    SectionWriter given_up(path);
    given_up.add(Kind::facts, 0, {}, bytesOf("new"));
  }
  EXPECT_EQ(gluray::test::textOf(folder.file("scene.gluray")), "old");
  EXPECT_EQ(filesIn(folder), std::vector<std::string>{"scene.gluray"});

  // As if the disk were full.
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{1000, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  {
    SectionWriter full(path);
    full.add(Kind::facts, 0, {}, bytesOf(std::string(5000, 'n')));
    EXPECT_FALSE(full.finish());
    EXPECT_NE(full.why().find("cannot be written"), std::string::npos) << full.why();
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(gluray::test::textOf(folder.file("scene.gluray")), "old");
  EXPECT_EQ(filesIn(folder), std::vector<std::string>{"scene.gluray"});

  SectionWriter nowhere(folder.file("missing/scene.gluray"));
  nowhere.add(Kind::facts, 0, {}, bytesOf("new"));
  EXPECT_FALSE(nowhere.finish());
  EXPECT_NE(nowhere.why(), "");
}

}  // namespace
}  // namespace gluray::saved
