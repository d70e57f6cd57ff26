#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <optional>
#include <string>

#include "batten/base/error.hpp"
#include "batten/io/json.hpp"
#include "batten/io/table.hpp"
#include "batten/io/write_points.hpp"
#include "errors.hpp"
#include "shared.hpp"

namespace batten {
namespace readers_test {

using testing::complaint_of;
using testing::inf;
using testing::nan;

namespace fs = std::filesystem;

std::string points_complaint(const std::string& name, const std::string& text,
                             const std::string& picks = {}) {
    return complaint_of([&] {
        const Table table = parse_table({name, text});
        points_of(table, coordinate_columns(table, picks));
    });
}
std::string csv(const std::string& text, const std::string& picks = {}) {
    return points_complaint("p.csv", text, picks);
}
std::string npy(const std::string& text) { return points_complaint("p.npy", text); }

TEST(BadFile, IsNamedWithTheReason) {
    EXPECT_EQ(complaint_of([] { read_source("no/such.csv"); }),
              "file.missing: no/such.csv: no such file: the input file must exist");
    EXPECT_EQ(complaint_of([] { read_source(""); }),
              "file.missing: '': no such file: the input file must exist");
    const std::string file = testing::scratch_file("readers/file.txt");
    write_file(file, "x");
    const std::string folder = fs::path(file).parent_path().string();
    EXPECT_EQ(complaint_of([&] { read_source(folder); }),
              "file.directory: " + folder + ": a folder: the input must be a file");
    EXPECT_EQ(complaint_of([&] { read_source(file + "/below.csv"); }),
              "file.missing: " + file + "/below.csv: no such file: the input file must exist");
    fs::remove(file);
}

TEST(BadFile, ThatCannotBeReadIsNamed) {
    // Opens, but its first page is not mapped: reading it fails, whoever reads.
    const char* const unreadable = "/proc/self/mem";
    if (!fs::exists(unreadable)) GTEST_SKIP() << "needs " << unreadable;
    EXPECT_EQ(complaint_of([&] { read_source(unreadable); }).substr(0, 15), "file.unreadable");
}

TEST(BadFile, ThatIsTooLargeIsRefusedUnread) {
    const std::string file = testing::scratch_file("readers/large.csv");
    write_file(file, "1,2\n");
    fs::resize_file(file, most_bytes + 1);
    EXPECT_EQ(complaint_of([&] { read_source(file); }),
              "file.too-large: " + file + ": more than 1073741824 bytes: at most 1073741824 bytes "
              "are read");
    fs::remove(file);
}

TEST(BadOutput, NamesItsFolder) {
    const std::string file = testing::scratch_file("readers/out.txt");
    const std::string folder = fs::path(file).parent_path().string();
    EXPECT_EQ(complaint_of([&] { write_file(folder + "/none/out.txt", "x"); }),
              "file.unwritable: " + folder + "/none/out.txt: no such folder: the folder " + folder +
                  "/none must exist and allow writing");
    EXPECT_EQ(complaint_of([&] { write_file(folder, "x"); }).substr(0, 15), "file.unwritable");
    EXPECT_EQ(complaint_of([] { write_file("", "x"); }),
              "file.unwritable: '': no name: the folder . must exist and allow writing");
    write_file(file, "x");
    EXPECT_EQ(complaint_of([&] { write_file(file + "/below.txt", "x"); }),
              "file.unwritable: " + file + "/below.txt: not a folder: the folder " + file +
                  " must exist and allow writing");
    fs::remove(file);
    EXPECT_TRUE(fs::is_empty(folder));
}

TEST(BadText, WithoutRowsIsRefused) {
    const std::string none = "file.empty: p.csv: no rows: the file must hold rows of numbers";
    for (const char* text : {"", " \n\t\n", "# a remark\n", "x,y\n", "\xEF\xBB\xBF"}) {
        EXPECT_EQ(csv(text), none) << text;
    }
}

TEST(BadText, WithRaggedRowsIsRefused) {
    EXPECT_EQ(csv("x,y\n1,2\n3,4,5\n"),
              "table.ragged: p.csv row 3: 3 columns: every row must have 2 columns, like row 1");
    EXPECT_EQ(csv("# remark\n1,2\n\n3\n"),
              "table.ragged: p.csv row 4: 1 columns: every row must have 2 columns, like row 2");
}

TEST(BadText, WithAWordForANumberIsRefused) {
    EXPECT_EQ(csv("x,y\n1,2\n3,four\n"),
              "table.not-a-number: p.csv row 3, column y: four: a number is needed here");
    EXPECT_EQ(csv("1,2\n3,\n"),
              "table.not-a-number: p.csv row 2, column #2: an empty cell: a number is needed here");
    EXPECT_EQ(csv("x,2\n3,4\n"),
              "table.not-a-number: p.csv row 1, column #1: x: a number is needed here");
    EXPECT_EQ(csv("1,5;2,5\n"), "table.not-a-number: p.csv row 1, column #1: 1,5: a number is "
                                "needed here, with a decimal point");
    EXPECT_EQ(csv("1,0x10\n"),
              "table.not-a-number: p.csv row 1, column #2: 0x10: a number is needed here");
    EXPECT_EQ(csv("1,\xFF\n"), "table.not-a-number: p.csv row 1, column #2: \xEF\xBF\xBD: a number "
                               "is needed here");
}

TEST(BadText, WithANumberThatIsNotFiniteIsRefused) {
    EXPECT_EQ(csv("x,y\n1,2\n3,NaN\n"),
              "points.not-finite: p.csv row 3, column y: nan: coordinates must be finite");
    EXPECT_EQ(csv("-Infinity,2\n"),
              "points.not-finite: p.csv row 1, column #1: -inf: coordinates must be finite");
    EXPECT_EQ(csv("1,2\n1e999,2\n"), "number.overflow: p.csv row 2, column #1: 1e999: numbers must "
                                     "lie within the range of a double");
    EXPECT_EQ(csv("1,-0.1e400\n"), "number.overflow: p.csv row 1, column #2: -0.1e400: numbers "
                                   "must lie within the range of a double");
}

TEST(BadText, TellsTheRowsToBlame) {
    try {
        const Table table = parse_table({"p.csv", "x,y\n1,2\n3,4\n5,nan\n"});
        points_of(table, coordinate_columns(table));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.rows(), std::vector<std::size_t>({2}));
    }
}

TEST(BadText, WithBrokenQuotesIsRefused) {
    EXPECT_EQ(csv("\"1,2\n3,4\n"), "table.quote: p.csv row 1: \"1,2: a quoted cell must end on its "
                                   "line, before the next separator");
    EXPECT_EQ(csv("1,2\n\"3\"4,5\n").substr(0, 24), "table.quote: p.csv row 2");
}

TEST(BadText, ThatIsNoTextIsRefused) {
    EXPECT_EQ(csv(std::string("1,2\n\0\0,3\n", 9)), "table.encoding: p.csv row 2: byte 0x00: a "
                                                    "table in text form must be UTF-8 or ASCII");
    EXPECT_EQ(csv(std::string("\xFF\xFE" "1\0,\0", 6)).substr(0, 14), "table.encoding");
}

TEST(BadText, OfTooManyColumnsIsRefused) {
    EXPECT_EQ(csv(std::string(70000, ',')), "table.too-wide: p.csv row 1: 70001 columns: at most "
                                            "65536 columns are read");
}

TEST(BadColumns, AreNamedWithTheChoices) {
    EXPECT_EQ(csv("x,y,sigma\n1,2,3\n", "x,q"), "table.unknown-column: p.csv: q: the columns are "
                                                "x, y, sigma (or #1 to #3)");
    for (const char* pick : {"x,#4", "x,#0", "x,#", "x,#1.5", "x,"}) {
        EXPECT_EQ(csv("x,y,sigma\n1,2,3\n", pick).substr(0, 20), "table.unknown-column") << pick;
    }
    EXPECT_EQ(csv("1,2\n", "x,y"), "table.unknown-column: p.csv: x: the file has no header: #1 to #2");
    EXPECT_EQ(csv("x,x\n1,2\n", "x,x"), "table.ambiguous-column: p.csv: x: two columns have this "
                                        "name: pick by #k");
    EXPECT_EQ(csv("1,2,3\n", "#1"), "table.columns: p.csv: #1: pick two or three columns as "
                                    "coordinates; the file has no header: #1 to #3");
    EXPECT_EQ(csv("a,b,c,d\n1,2,3,4\n"), "table.columns: p.csv: 4 columns: pick two or three "
                                         "columns as coordinates; the columns are a, b, c, d (or "
                                         "#1 to #4)");
    EXPECT_EQ(csv("1\n2\n"), "table.columns: p.csv: 1 columns: pick two or three columns as "
                             "coordinates; the file has no header: #1 to #1");
}

TEST(BadAerofoil, WithWrongCountsIsRefused) {
    EXPECT_EQ(points_complaint("a.dat", "NACA 0012\n 4. 3.\n\n0 0\n1 0\n\n0 0\n1 0\n"),
              "aerofoil.counts: a.dat row 2: 4 + 3 points: 4 points follow: the counts must add up");
    EXPECT_EQ(points_complaint("a.dat", "NACA 0012\n1 0\n0 0 0\n").substr(0, 12), "table.ragged");
    EXPECT_EQ(points_complaint("a.dat", "NACA 0012\n1 0\n0 zero\n"),
              "table.not-a-number: a.dat row 3, column y: zero: a number is needed here");
}

TEST(BadJsonPoints, AreNamedByTheirRow) {
    const auto json = [](const std::string& text) { return points_complaint("p.json", text); };
    const std::string rule = "points are a list of lists of numbers: [[x, y], ...]";
    EXPECT_EQ(json(R"({"points": [[0, 1]]})"), "table.json: p.json: a map: " + rule);
    EXPECT_EQ(json("[0, 1]"), "table.json: p.json row 1: a single value: " + rule);
    EXPECT_EQ(json("[[0, 1], []]"), "table.json: p.json row 2: an empty list: " + rule);
    EXPECT_EQ(json("[]"), "file.empty: p.json: no rows: the file must hold rows of numbers");
    EXPECT_EQ(json("[[0, 1], [2, 3, 4]]"), "table.ragged: p.json row 2: 3 columns: every row must "
                                           "have 2 columns, like row 1");
    EXPECT_EQ(json("[[0, 1], [null, 2]]"), "table.not-a-number: p.json row 2, column #1: null: a "
                                           "number is needed here");
    EXPECT_EQ(json("[[0, \"2\"]]"), "table.not-a-number: p.json row 1, column #2: \"2\": a number "
                                    "is needed here");
}

std::string npy_file(const std::string& header, const std::string& body) {
    std::string text("\x93NUMPY\x01\x00", 8);
    text += static_cast<char>(header.size() & 0xFF);
    text += static_cast<char>(header.size() >> 8);
    return text + header + body;
}
std::string npy_of_shape(const std::string& shape) {
    return npy_file("{'descr': '<f8', 'fortran_order': False, 'shape': " + shape + ", }\n",
                    std::string(16, '\0'));
}

TEST(BadNumPyFile, WithABrokenHeaderIsRefused) {
    const std::string rule =
        ": the header must tell descr, fortran_order and shape, and nothing else";
    EXPECT_EQ(npy("no NumPy file"), "npy.header: p.npy: other first bytes: a NumPy file starts "
                                    "with \\x93NUMPY");
    EXPECT_EQ(npy("\x93NUMPY"), "npy.header: p.npy: end of file: the header is cut short");
    EXPECT_EQ(npy(std::string("\x93NUMPY\x01\x00\xFF\xFF{}", 12)),
              "npy.header: p.npy: end of file: the header is cut short");
    EXPECT_EQ(npy(std::string("\x93NUMPY\x04\x00\x02\x00{}", 12)),
              "npy.header: p.npy: version 4: versions 1, 2 and 3 are read");
    EXPECT_EQ(npy(npy_file("{}", "")), "npy.header: p.npy: an entry is missing" + rule);
    EXPECT_EQ(npy(npy_file("{'descr'", "1234")), "npy.header: p.npy: end of header" + rule);
    EXPECT_EQ(npy(npy_file("{'more': 1}", "")), "npy.header: p.npy: more" + rule);
    for (const char* header :
         {"", "[]", "{'descr': 3}", "{'shape': 3}", "{'shape': (3", "{'shape': (3 3)}",
          "{'shape': (-3,)}", "{'shape': (99999999999999999999,)}", "{'fortran_order': 0}",
          "{'descr': '<f8' 'shape': (1,)}", "{'shape': (,)}", "{descr: '<f8'}"}) {
        EXPECT_EQ(npy(npy_file(header, "1234")).substr(0, 10), "npy.header") << header;
    }
}

TEST(BadNumPyFile, OfAnotherTypeIsRefused) {
    const auto typed = [](const std::string& type) {
        return npy(npy_file("{'descr': " + type + ", 'fortran_order': False, 'shape': (1, 2)}", ""));
    };
    EXPECT_EQ(typed("'<c16'"),
              "npy.type: p.npy: <c16: floats of 4 or 8 bytes and integers are read");
    for (const char* type : {"'|O'", "'<f2'", "'<f16'", "'|b1'", "'<U5'", "'<i3'", "'f8'", "'?f8'",
                             "''", "[('x', '<f8')]"}) {
        EXPECT_EQ(typed(type).substr(0, 8), "npy.type") << type;
    }
}

TEST(BadNumPyFile, ThatDeclaresMoreThanItHoldsIsRefused) {
    EXPECT_EQ(npy(npy_of_shape("(100000000, 2)")), "npy.truncated: p.npy: 16 bytes: 100000000 x 2 "
                                                   "numbers of 8 bytes are declared");
    // 2^61 rows of 8 bytes would be 2^64 bytes: 0 to careless hands.
    EXPECT_EQ(npy(npy_of_shape("(2305843009213693952,)")).substr(0, 13), "npy.truncated");
    EXPECT_EQ(npy(npy_of_shape("(4611686018427387904, 4)")).substr(0, 13), "npy.truncated");
}

TEST(BadNumPyFile, OfAnotherShapeIsRefused) {
    const std::string rule =
        ": an array of one or two dimensions, at most 65536 columns, is needed";
    EXPECT_EQ(npy(npy_of_shape("(1, 1, 2)")), "npy.shape: p.npy: 1 x 1 x 2" + rule);
    EXPECT_EQ(npy(npy_of_shape("()")), "npy.shape: p.npy: a single value" + rule);
    EXPECT_EQ(npy(npy_of_shape("(1, 100000)")), "npy.shape: p.npy: 1 x 100000" + rule);
    EXPECT_EQ(npy(npy_of_shape("(0, 2)")).substr(0, 10), "file.empty");
    EXPECT_EQ(npy(npy_of_shape("(2, 0)")).substr(0, 10), "file.empty");
}

TEST(BadNumPyFile, WithANumberThatIsNotFiniteIsRefused) {
    const std::string file = testing::source_file("tests/fuzz/corpus/npy/not_finite.npy");
    EXPECT_EQ(complaint_of([&] { read_points(file); }),
              "points.not-finite: " + file + " row 2, column #1: nan: coordinates must be finite");
}

TEST(BadJson, IsPlacedByLineAndColumn) {
    const auto json = [](const std::string& text) {
        return complaint_of([&] { parse_json(text, "j"); });
    };
    const struct {
        const char* text;
        const char* complaint;
    } cases[] = {
        {"", "json.syntax: j line 1, column 1: end of text: a value is needed here"},
        {"{\n  \"a\": ]", "json.syntax: j line 2, column 8: ']': a value is needed here"},
        {"[1, 2", "json.syntax: j line 1, column 6: end of text: a list goes on with , or ends "
                  "with ]"},
        {"[1, ]", "json.syntax: j line 1, column 5: ']': a value is needed here"},
        {"{1: 2}", "json.syntax: j line 1, column 2: '1': a key in double quotes is needed here"},
        {"{\"a\" 2}", "json.syntax: j line 1, column 6: '2': a key is followed by :"},
        {"{\"a\": 2 3", "json.syntax: j line 1, column 9: '3': a map goes on with , or ends with }"},
        {"1 2", "json.syntax: j line 1, column 3: '2': the text must end after its one value"},
        {"nan", "json.syntax: j line 1, column 1: 'n': a value is needed here"},
        {"NaN", "json.syntax: j line 1, column 1: 'N': a value is needed here"},
        {"-Infinity", "json.syntax: j line 1, column 1: '-': a value is needed here"},
        {"01", "json.syntax: j line 1, column 3: end of text: a number may not start with 0"},
        {"1.", "json.syntax: j line 1, column 3: end of text: digits are needed after the point"},
        {"1e+", "json.syntax: j line 1, column 4: end of text: digits are needed in the exponent"},
        {"\"a", "json.syntax: j line 1, column 3: end of text: a text ends with a double quote"},
        {"\"\t\"", "json.syntax: j line 1, column 2: byte 0x09: a text must be UTF-8, without "
                   "control characters"},
        {"\"\xC0\x80\"", "json.syntax: j line 1, column 2: byte 0xC0: a text must be UTF-8, "
                         "without control characters"},
        {"\"\\x\"", "json.syntax: j line 1, column 3: 'x': no such escape sequence"},
        {"\"\\u12g4\"", "json.syntax: j line 1, column 6: 'g': four hexadecimal digits are needed "
                        "here"},
        {"\"\\ud800\"", "json.syntax: j line 1, column 8: '\"': half of a surrogate pair"},
        {"{\"a\": 1,\n \"a\": 2}", "json.duplicate-key: j line 2, column 2: a: a key may stand only "
                                   "once in a map"},
        {"[0, 1e400]", "number.overflow: j line 1, column 5: 1e400: numbers must lie within the "
                       "range of a double"},
    };
    for (const auto& c : cases) EXPECT_EQ(json(c.text), c.complaint) << c.text;
}

TEST(BadJson, CannotEatTheMemory) {
    const auto json = [](const std::string& text) {
        return complaint_of([&] { parse_json(text, "j"); });
    };
    EXPECT_EQ(json(std::string(1'000'000, '[')), "json.too-deep: j line 1, column 65: more than 64: "
                                                 "at most 64 lists and maps may lie inside one "
                                                 "another");
    EXPECT_EQ(json(std::string(64, '[') + std::string(64, ']')), "none");
    const std::string list = "[[1, 2],\n[3]]";
    EXPECT_EQ(complaint_of([&] { parse_json(list, "j", {.values = 6}); }), "none");
    EXPECT_EQ(complaint_of([&] { parse_json(list, "j", {.values = 5}); }),
              "json.too-large: j line 2, column 2: more than 5: at most 5 values are read");
}

TEST(BadNumbers, AreNeverWritten) {
    EXPECT_EQ(complaint_of([&] { dump_json(ValueList{nan}); }),
              "number.overflow: output: nan: results must lie within the range of a double");
    const Points points({0, 1, 2, -inf}, 2);
    for (const auto& write : {complaint_of([&] { csv_points(points, {}); }),
                              complaint_of([&] { json_points(points); }),
                              complaint_of([&] { npy_points(points); })}) {
        EXPECT_EQ(write, "number.overflow: output row 1, column 1: -inf: results must lie within "
                         "the range of a double");
    }
}

}  // namespace readers_test
}  // namespace batten
