#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "batten/base/error.hpp"
#include "batten/io/files.hpp"
#include "batten/io/json.hpp"
#include "shared.hpp"

namespace batten {
namespace files_io_test {

namespace fs = std::filesystem;

std::size_t files_in(const fs::path& folder) {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

class WrittenFile : public ::testing::Test {
protected:
    void SetUp() override {
        path_ = testing::scratch_file("files_io/out.txt");
        fs::remove_all(folder());
        fs::create_directory(folder());
    }
    void TearDown() override { fs::remove_all(folder()); }
    fs::path folder() const { return fs::path(path_).parent_path(); }

    std::string path_;
};

TEST_F(WrittenFile, HoldsItsBytesAndLeavesNothingElse) {
    const std::string bytes("a\0b\r\n", 5);
    write_file(path_, bytes);
    EXPECT_EQ(read_source(path_).bytes, bytes);
    EXPECT_EQ(files_in(folder()), 1u);
    write_file(path_, "new");
    EXPECT_EQ(read_source(path_).bytes, "new");
    EXPECT_EQ(files_in(folder()), 1u);
}

TEST_F(WrittenFile, KeepsThePermissionsOfTheOneBefore) {
    write_file(path_, "old");
    const fs::perms perms = fs::perms::owner_read | fs::perms::owner_write;
    fs::permissions(path_, perms);
    write_file(path_, "new");
    EXPECT_EQ(fs::status(path_).permissions(), perms);
}

TEST_F(WrittenFile, IsTheOneALinkPointsTo) {
    write_file(path_, "old");
    const fs::path link = folder() / "link.txt";
    fs::create_symlink("out.txt", link);
    write_file(link.string(), "new");
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(read_source(path_).bytes, "new");
}

TEST_F(WrittenFile, StepsAsideForTheDraftsOfOthers) {
    testing::write_text((folder() / ".batten-0.part").string(), "somebody's");
    write_file(path_, "mine");
    EXPECT_EQ(read_source(path_).bytes, "mine");
    EXPECT_EQ(read_source((folder() / ".batten-0.part").string()).bytes, "somebody's");
}

TEST_F(WrittenFile, MayBeADevice) {
    if (!fs::is_character_file("/dev/null")) GTEST_SKIP() << "needs /dev/null";
    write_file("/dev/null", "nothing");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(Suffix, IsWhatFollowsTheLastDotOfTheName) {
    EXPECT_EQ(suffix_of("out/Points.CSV"), "csv");
    EXPECT_EQ(suffix_of("a.b/points"), "");
    EXPECT_EQ(suffix_of("points.tar.gz"), "gz");
    EXPECT_EQ(suffix_of("points."), "");
    EXPECT_EQ(suffix_of(""), "");
}

TEST(JsonText, KeepsWhatIsShortOnOneLine) {
    const Value report(ValueMap{
        {"status", "met"},
        {"report", ValueMap{{"length", 1.5}, {"area", nullptr}, {"is_simple", true}}},
        {"none", ValueList{}},
        {"list", ValueList(40, Value(1234567))}});
    EXPECT_EQ(dump_json(report), R"({
  "status": "met",
  "report": {"length": 1.5, "area": null, "is_simple": true},
  "none": [],
  "list": [
    1234567, 1234567, 1234567, 1234567, 1234567, 1234567, 1234567, 1234567, 1234567, 1234567,
    1234567, 1234567, 1234567, 1234567, 1234567, 1234567, 1234567, 1234567, 1234567, 1234567,
    1234567, 1234567, 1234567, 1234567, 1234567, 1234567, 1234567, 1234567, 1234567, 1234567,
    1234567, 1234567, 1234567, 1234567, 1234567, 1234567, 1234567, 1234567, 1234567, 1234567
  ]
}
)");
    EXPECT_EQ(dump_json(ValueList{1, "a\"\\\n\x01", -0.0}, JsonStyle::one_line),
              "[1, \"a\\\"\\\\\\u000a\\u0001\", -0]");
    EXPECT_EQ(dump_json(Value("\xFF" "a"), JsonStyle::one_line), "\"\xEF\xBF\xBD" "a\"");
}

TEST(JsonText, IsReadWithItsEscapesAndTheSignOfZero) {
    const Value value = parse_json(R"(["\u00e9\ud83d\ude00\/", -0, 9007199254740993, 1e5])", "t");
    const ValueList& list = *value.list();
    EXPECT_EQ(*list[0].text(), "\xC3\xA9\xF0\x9F\x98\x80/");
    EXPECT_TRUE(std::signbit(*list[1].real()));
    EXPECT_EQ(*list[2].integer(), 9007199254740993);
    EXPECT_EQ(*list[3].real(), 1e5);
}

}  // namespace files_io_test
}  // namespace batten
