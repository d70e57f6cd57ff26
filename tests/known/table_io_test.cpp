#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "batten/base/error.hpp"
#include "batten/io/table.hpp"
#include "shared.hpp"

namespace batten {
namespace table_io_test {

/// A file that NumPy wrote.
std::string npy_file(const std::string& name) {
    return testing::source_file("tests/fuzz/corpus/npy/" + name + ".npy");
}

Table table_of(const std::string& name, const std::string& text) {
    return parse_table({name, text});
}

Points points_in(const std::string& name, const std::string& text) {
    const Table table = table_of(name, text);
    return points_of(table, coordinate_columns(table));
}

Points plane(std::vector<double> coordinates) { return {std::move(coordinates), 2}; }

using Lines = std::vector<int>;
using Names = std::vector<std::string>;

TEST(TextTable, IsReadWhateverStandsBetweenItsCells) {
    const Points expected = plane({0, 1, 2.5, -3});
    for (const char* text : {"0,1\n2.5,-3\n", "0;1\n2.5;-3", "0\t1\n2.5\t-3\n", "0 1\n2.5 -3\n",
                             "  0   1 \n\n 2.5\t-3\n", " 0 , 1 \r\n 2.5 , -3 \r\n", "0,1\r2.5,-3\r",
                             "\xEF\xBB\xBF" "0,1\n2.5,-3\n", "\"0\",\"1\"\n\"2.5\",-3\n"}) {
        EXPECT_EQ(points_in("p.csv", text), expected) << text;
    }
}

TEST(TextTable, TakesItsNamesFromTheHeader) {
    EXPECT_EQ(table_of("p.csv", "x,y\n1,2\n").names, Names({"x", "y"}));
    EXPECT_EQ(table_of("p.csv", "\"x, \"\"east\"\"\",y\n1,2\n").names, Names({"x, \"east\"", "y"}));
    EXPECT_EQ(table_of("p.csv", "\"a;b\",c\n1,2\n").names, Names({"a;b", "c"}));
    EXPECT_EQ(table_of("p.csv", ",y\n1,2\n").label(0), "#1");
    EXPECT_TRUE(table_of("p.csv", "1,2\n3,4\n").names.empty());
}

TEST(TextTable, TakesItsNamesFromAFirstCommentOfAsManyWords) {
    EXPECT_EQ(table_of("p.csv", "# x_m,y_m\n1,2\n").names, Names({"x_m", "y_m"}));
    EXPECT_EQ(table_of("p.txt", "# x y\n1 2\n").names, Names({"x", "y"}));
    EXPECT_EQ(table_of("p.txt", "#x, y\n1 2\n").names, Names({"x", "y"}));
    EXPECT_EQ(table_of("p.csv", "# a,b\nx,y\n1,2\n").names, Names({"x", "y"}));
    for (const char* text : {"# x y z\n1 2\n", "# 5 6\n1 2\n", "# one\n# x y\n1 2\n", "1 2\n# x y\n"}) {
        EXPECT_TRUE(table_of("p.txt", text).names.empty()) << text;
    }
}

TEST(TextTable, KnowsTheLineOfEachRow) {
    EXPECT_EQ(table_of("p.csv", "# c\nx,y\n\n1,2\n# c\n3,4  # a remark\n").line_of_row, Lines({4, 6}));
}

TEST(TextTable, MayHoldColumnsOfWordsThatNobodyAsksFor) {
    const Table table = table_of("p.csv", "name,x,y\n\"a, b\",1,2\nc,3,4\n");
    EXPECT_EQ(points_of(table, coordinate_columns(table, "x,y")), plane({1, 2, 3, 4}));
    EXPECT_EQ(points_of(table, coordinate_columns(table, "#3, x")), plane({2, 1, 4, 3}));
    EXPECT_EQ(column_values(table, column_index(table, "#2")), std::vector<double>({1, 3}));
}

TEST(TextTable, GivesInfiniteErrorsWhereTheyMeanNoWeight) {
    const double inf = std::numeric_limits<double>::infinity();
    for (const char* word : {"inf", "Infinity", "+inf"}) {
        const std::string cell = word;
        const Table table = table_of("d.csv", "x,sigma\n1,2\n2," + cell + "\n3,4\n");
        EXPECT_EQ(column_errors(table, 1), (std::vector<double>{2, inf, 4})) << word;
        EXPECT_THROW(column_values(table, 1), Error) << word;
    }
    for (const char* word : {"-inf", "nan", "1e999", "many", ""}) {
        const std::string cell = word;
        const Table table = table_of("d.csv", "x,sigma\n1,inf\n2," + cell + "\n3,4\n");
        EXPECT_THROW(column_errors(table, 1), Error) << word;
    }
}

TEST(TextTable, OfManyColumnsHasItsCoordinatesUnderXYAndZ) {
    const Table table = table_of("s.csv", "i,time,x,y,z,kappa\n0,0,1,2,3,9\n");
    EXPECT_EQ(coordinate_columns(table), std::vector<int>({2, 3, 4}));
    EXPECT_EQ(coordinate_columns(table_of("s.csv", "x,y,sigma,fit\n0,1,2,3\n")),
              std::vector<int>({0, 1}));
}

TEST(NumPyTable, IsReadInEveryTypeAndOrder) {
    const Points floats = plane({0, 0.5, 1, -2, 2, 1e-300});
    Points singles = floats;
    singles(2, 1) = 0;
    for (const char* name : {"f8", "f8_big", "f8_fortran", "version2", "version3"}) {
        EXPECT_EQ(read_points(npy_file(name)), floats)
            << name;
    }
    for (const char* name : {"f4", "f4_big"}) {
        EXPECT_EQ(read_points(npy_file(name)), singles)
            << name;
    }
    for (const char* name : {"i1", "i2_big", "i4", "i8"}) {
        EXPECT_EQ(read_points(npy_file(name)),
                  plane({-1, 2, 100, -128, 3, 4}))
            << name;
    }
    for (const char* name : {"u1", "u2", "u4_big", "u8"}) {
        EXPECT_EQ(read_points(npy_file(name)),
                  plane({1, 2, 100, 255, 3, 4}))
            << name;
    }
    const Table column = read_table(npy_file("one_column"));
    EXPECT_EQ(column_values(column, 0), std::vector<double>({1, 2, 3}));
}

TEST(JsonTable, IsAListOfPoints) {
    EXPECT_EQ(points_in("p.json", "[[0, 1], [2.5, -3e0]]"), plane({0, 1, 2.5, -3}));
    EXPECT_EQ(points_in("p.json", "[[0, 1, 2]]"), Points({0, 1, 2}, 3));
}

const char* const selig = " NACA 0012\n1 0.001\n0.5 0.05\n0 0\n0.5 -0.05\n1 -0.001\n";
const char* const lednicer =
    "NACA 0012\n 3. 3.\n\n0 0\n0.5 0.05\n1 0.001\n\n0 0\n0.5 -0.05\n1 -0.001\n";

TEST(Aerofoil, InLednicersOrderIsTurnedIntoSeligs) {
    const Table table = table_of("a.dat", lednicer);
    EXPECT_EQ(table.cells, table_of("a.dat", selig).cells);
    EXPECT_EQ(table.line_of_row, Lines({6, 5, 4, 9, 10}));
    EXPECT_EQ(table.notes[0], "aerofoil: NACA 0012");
    EXPECT_EQ(table.names, Names({"x", "y"}));
}

TEST(Aerofoil, KeepsTwoNosesThatDiffer) {
    const Table table = table_of("a.dat", "A B C\n2 2\n\n0 0.1\n1 0\n\n0 -0.1\n1 0\n");
    EXPECT_EQ(table.cells, plane({1, 0, 0, 0.1, 0, -0.1, 1, 0}));
}

TEST(Aerofoil, WithoutItsSuffixIsKnownByItsTitle) {
    EXPECT_EQ(table_format({"standard input", " RAE 2822 AIRFOIL\n1 0\n0 0\n"}),
              TableFormat::aerofoil);
    EXPECT_EQ(table_format({"standard input", "x y\n1 0\n0 0\n"}), TableFormat::text);
    EXPECT_EQ(table_format({"p.dat", "1 0\n0 0\n"}), TableFormat::text);
    EXPECT_EQ(table_format({"p.dat", "x y\n3 4\n0 0\n"}), TableFormat::text);
}

TEST(TableFormat, OfANamelessSourceIsToldByItsContent) {
    EXPECT_EQ(table_format({"standard input", "\x93NUMPY..."}), TableFormat::npy);
    EXPECT_EQ(table_format({"standard input", "  [[0, 1]]"}), TableFormat::json);
    EXPECT_EQ(table_format({"standard input", "0,1\n"}), TableFormat::text);
    EXPECT_EQ(table_format({"p.JSON", ""}), TableFormat::json);
}

TEST(RealTables, AreRead) {
    const struct {
        const char* name;
        const char* picks;
        std::size_t rows;
    } tables[] = {{"data/rae2822.dat", "", 129},          {"data/clarky.dat", "", 121},
                  {"data/titanium.csv", "x,f", 49},       {"data/car-key-line-1.txt", "", 808},
                  {"data/cat.csv", "", 201},              {"data/monza-track.csv", "x_m,y_m", 1159}};
    for (const auto& table : tables) {
        SKIP_UNLESS_SHARED(table.name);
        const Points points = read_points(*testing::shared_file(table.name), table.picks);
        EXPECT_EQ(points.size(), table.rows) << table.name;
        EXPECT_GT(extent(points), 0) << table.name;
    }
}

}  // namespace table_io_test
}  // namespace batten
