#include "help.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

namespace batten::cli {
namespace {

constexpr std::size_t narrowest = 80, widest = 100;
/// What is named in a wider column has its text below it.
constexpr std::size_t widest_name = 26;

/// Columns that a UTF-8 text takes: its bytes without those that continue a character.
std::size_t columns_of(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

/// `text` in lines of at most `width` columns, `indent` blanks before all but the first.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t width) {
    std::string lines, word;
    std::size_t used = indent;
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find(' ', start), text.size());
        word = text.substr(start, end - start);
        start = end + 1;
        const std::size_t length = columns_of(word);
        if (used > indent && used + 1 + length > width) {
            lines += '\n' + std::string(indent, ' ');
            used = indent;
        } else if (used > indent) {
            lines += ' ';
            ++used;
        }
        lines += word;
        used += length;
    }
    return lines;
}

using Entry = std::pair<std::string, std::string>;

std::string listed(const std::string& title, const std::vector<Entry>& entries, std::size_t width) {
    if (entries.empty()) return {};
    std::size_t column = 0;
    for (const Entry& entry : entries) {
        const std::size_t length = columns_of(entry.first);
        if (length <= widest_name) column = std::max(column, length);
    }
    column += 4;
    std::string text = '\n' + title + ":\n";
    for (const auto& [name, help] : entries) {
        text += "  " + name;
        const std::size_t used = columns_of(name) + 2;
        text += used + 2 > column ? '\n' + std::string(column, ' ')
                                  : std::string(column - used, ' ');
        text += wrapped(help, column, width) + '\n';
    }
    return text;
}

Entry entry_of(const Flag& flag) {
    std::string name = flag.letter ? std::string("-") + flag.letter + ", " : "    ";
    name += "--" + flag.name + (flag.takes.empty() ? "" : ' ' + flag.takes);
    std::string help = flag.help, words;
    for (const std::string& word : flag.choices) words += (words.empty() ? ": " : ", ") + word;
    const std::size_t place = std::min(help.rfind(" ["), help.size());
    return {name, help.insert(place, words)};
}

std::vector<Entry> entries_of(const std::vector<Flag>& flags) {
    std::vector<Entry> entries;
    for (const Flag& flag : flags) entries.push_back(entry_of(flag));
    return entries;
}

}  // namespace

std::string help_text(std::size_t width) {
    std::vector<Entry> entries;
    for (const Verb& verb : verbs()) entries.emplace_back(verb.name, verb.help);
    return std::string(about) + "\n\nUsage: batten VERB INPUT [OPTIONS]\n" +
           listed("Verbs", entries, width) +
           listed("Options", {{"-h, --help", "print this help; batten VERB --help that of a verb"},
                              {"    --version", "print the version"}}, width) +
           '\n' + wrapped(habits, 0, width) + '\n';
}

std::string help_text(const Verb& verb, std::size_t width) {
    std::string text = wrapped("batten " + verb.name + ": " + verb.help, 0, width) +
                       "\n\nUsage: batten " + verb.name +
                       (verb.input.empty() ? "" : ' ' + verb.input) + " [OPTIONS]\n";
    if (!verb.input.empty()) text += listed("Input", {{verb.input, verb.input_help}}, width);
    std::vector<Entry> common = entries_of(verb.common);
    common.emplace_back("-h, --help", "print this help");
    return text + listed("Options", entries_of(verb.options), width) +
           listed("Files and messages", common, width);
}

std::size_t help_width() {
    winsize size{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return widest;
    return std::clamp<std::size_t>(size.ws_col, narrowest, widest);
}

}  // namespace batten::cli
