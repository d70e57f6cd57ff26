#include "shared.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "batten/base/text.hpp"

namespace batten::testing {
namespace {

std::vector<std::string> cells(std::string_view line) {
    std::vector<std::string> result;
    for (;;) {
        const std::size_t comma = line.find(',');
        result.emplace_back(trimmed(line.substr(0, comma)));
        if (comma == std::string_view::npos) return result;
        line.remove_prefix(comma + 1);
    }
}

std::string shared_path(std::string_view name) {
    return std::string(BATTEN_SHARED_DIR "/").append(name);
}

}  // namespace

std::size_t CsvTable::index(std::string_view name) const {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) throw std::out_of_range("no column " + std::string(name));
    return static_cast<std::size_t>(found - names.begin());
}

const std::string& CsvTable::text(std::size_t row, std::string_view name) const {
    return rows.at(row).at(index(name));
}

double CsvTable::number(std::size_t row, std::string_view name) const {
    const std::optional<double> value = parse_number(text(row, name));
    if (!value) throw std::runtime_error("not a number: " + text(row, name));
    return *value;
}

std::vector<double> CsvTable::column(std::string_view name) const {
    std::vector<double> result;
    for (std::size_t row = 0; row < rows.size(); ++row) result.push_back(number(row, name));
    return result;
}

std::optional<std::string> shared_file(std::string_view name) {
    const std::string path = shared_path(name);
    if (!std::filesystem::exists(path)) return std::nullopt;
    return path;
}

CsvTable shared_csv(std::string_view name) { return parse_csv(read_text(shared_path(name))); }

std::string source_file(std::string_view name) {
    return std::string(BATTEN_SOURCE_DIR "/").append(name);
}

std::string scratch_file(std::string_view name) {
    // Tests run beside each other: what one writes or removes is no other's.
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    const std::string owner = test ? std::string(test->test_suite_name()) + '.' + test->name() : "";
    const std::filesystem::path path =
        std::filesystem::path(BATTEN_SCRATCH_DIR "/scratch") / owner / name;
    std::filesystem::create_directories(path.parent_path());
    return path.string();
}

std::string read_text(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) throw std::runtime_error("cannot read " + path);
    return {std::istreambuf_iterator<char>(in), {}};
}

void write_text(const std::string& path, std::string_view text) {
    std::ofstream out(path, std::ios::binary);
    out << text;
    if (!out.flush()) throw std::runtime_error("cannot write " + path);
}

CsvTable parse_csv(std::string_view text) {
    CsvTable table;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.empty() || line.front() == '#') continue;
        if (table.names.empty()) {
            table.names = cells(line);
        } else {
            table.rows.push_back(cells(line));
        }
    }
    return table;
}

::testing::AssertionResult is_golden(std::string_view name, std::string_view text) {
    const std::string golden = source_file(std::string("tests/picture/golden/").append(name));
    if (std::filesystem::exists(golden) && read_text(golden) == text) {
        return ::testing::AssertionSuccess();
    }
    const std::string found = scratch_file(std::string("golden/").append(name));
    write_text(found, text);
    const char* wish = std::getenv("BATTEN_GOLDEN");
    if (wish && std::string_view(wish) == "accept") {
        std::filesystem::create_directories(std::filesystem::path(golden).parent_path());
        write_text(golden, text);
    }
    return ::testing::AssertionFailure() << found << " differs from " << golden;
}

}  // namespace batten::testing
