#include "batten/api/operation.hpp"
#include "pages.hpp"
#include "cli/vocabulary.hpp"

namespace batten::cli {
namespace {

/// `text` with what troff would take for its own made plain.
std::string plain(const std::string& text) {
    std::string result = !text.empty() && (text[0] == '.' || text[0] == '\'') ? "\\&" : "";
    for (const char c : text) {
        if (c == '-') {
            result += "\\-";
        } else if (c == '\\') {
            result += "\\e";
        } else {
            result += c;
        }
    }
    return result;
}

std::string entry(const Flag& flag) {
    std::string text = ".TP\n";
    if (flag.letter) text += "\\fB\\-" + std::string(1, flag.letter) + "\\fR, ";
    text += "\\fB\\-\\-" + plain(flag.name) + "\\fR";
    if (!flag.takes.empty()) text += " \\fI" + plain(flag.takes) + "\\fR";
    text += '\n' + plain(flag.help) + '\n';
    std::string words;
    for (const std::string& word : flag.choices) {
        words += (words.empty() ? "" : ", ") + ("\\fB" + plain(word) + "\\fR");
    }
    return words.empty() ? text : text + ".br\nOne of " + words + ".\n";
}

std::string section(const Verb& verb) {
    std::string text = ".SS \"batten " + plain(verb.name) + ' ' + plain(verb.input) + "\"\n" +
                       plain(verb.help) + ".\n";
    for (const Flag& flag : verb.options) text += entry(flag);
    return text;
}

}  // namespace

std::string man_page() {
    std::string text = ".TH BATTEN 1 \"\" \"batten " + std::string(version()) +
                       "\" \"User commands\"\n.SH NAME\nbatten \\- fair curves through points, and "
                       "how good they are\n.SH SYNOPSIS\n.B batten\n.I VERB INPUT\n"
                       ".RI [ OPTIONS ]\n.br\n.B batten run\n.I JOB.json\n.SH DESCRIPTION\n" +
                       plain(habits) + "\n.SH \"FILES AND MESSAGES\"\n" +
                       "Every verb takes those of these options that suit its input and output.\n";
    std::vector<std::string> seen;
    for (const Operation& operation : operations()) {
        for (const Flag& flag : verb_of(operation).common) {
            bool known = false;
            for (const std::string& name : seen) known = known || name == flag.name;
            if (known) continue;
            seen.push_back(flag.name);
            text += entry(flag);
        }
    }
    text += ".SH VERBS\n";
    for (const Verb& verb : verbs()) text += section(verb);
    return text;
}

}  // namespace batten::cli
