#include "vocabulary.hpp"

#include <algorithm>
#include <cctype>

namespace batten::cli {
namespace {

const CommonFlag progress_flag{{"progress", 0, "WHEN", "progress of long work on standard error [auto]",
                                {"auto", "always", "never"}},
                               &Command::progress};
const CommonFlag quiet_flag{{"quiet", 0, "", "no summary on standard error"}, &Command::quiet};

/// `points_or_curve` as `POINTS|CURVE`; nothing for an operation without input.
std::string input_word(InputKind kind) {
    if (kind == InputKind::none) return {};
    std::string word(name_of(kind));
    for (std::size_t joint; (joint = word.find("_or_")) != std::string::npos;) {
        word.replace(joint, 4, "|");
    }
    std::transform(word.begin(), word.end(), word.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return word;
}

std::vector<Flag> flags_in(const std::vector<CommonFlag>& common) {
    std::vector<Flag> flags;
    for (const CommonFlag& each : common) flags.push_back(each.flag);
    return flags;
}

/// `csv, json or npy`.
std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
    }
    return text;
}

}  // namespace

const char* const about = "Batten: fair curves through points, and how good they are.";

const char* const habits =
    "Every verb reads one input (- for standard input) and writes curves as JSON, points as CSV, "
    "to standard output or to -o FILE. Verbs read what other verbs write, for example "
    "`batten interpolate points.csv | batten measure -`. "
    "Exit status: 0 done, 2 bad input, 3 the result misses what was asked, 1 anything else.";

std::string flag_name(const std::string& field) {
    std::string name = field;
    std::replace(name.begin(), name.end(), '_', '-');
    return name;
}

std::vector<CommonFlag> common_flags(const Operation& operation) {
    std::vector<CommonFlag> flags{
        {{"output", 'o', "FILE", "write the result to this file, its form by suffix", {}, true},
         &Command::output},
        {{"format", 0, "NAME",
          "the form to write where no suffix says it: " + listed(operation.forms)},
         &Command::format},
        {{"report", 0, "FILE", "write the report as JSON, - for standard output", {}, true},
         &Command::report}};
    if (operation.output != OutputKind::drawing) {
        flags.push_back({{"draw", 0, "FILE.svg|png|pdf", "draw what was done; png and pdf by gnuplot",
                          {}, true},
                         &Command::drawing});
    }
    if (takes_rows(operation.input) && operation.input != InputKind::grid) {
        flags.push_back({{"columns", 0, "X,Y[,Z]",
                          "columns that hold the coordinates: names or #k, k from 1"},
                         &Command::columns});
    }
    flags.push_back(progress_flag);
    flags.push_back(quiet_flag);
    return flags;
}

std::vector<CommonFlag> run_flags() { return {progress_flag, quiet_flag}; }

Flag flag_of(const Field& field) {
    std::string help = field.help;
    if (!field.bare.empty()) help += " (alone: " + field.bare + ")";
    if (!field.default_text.empty()) help += " [" + field.default_text + "]";
    const bool is_choice = !field.choices.empty();
    return {flag_name(field.name), 0, is_choice ? "WORD" : field.takes, help, field.choices,
            field.takes_file};
}

Verb verb_of(const Operation& operation) {
    Verb verb{std::string(operation.name), std::string(operation.help),
              input_word(operation.input), "the file to read, - for standard input",
              flags_in(common_flags(operation)), {}};
    if (operation.many_inputs) {
        verb.input += "…";
        verb.input_help = "the files to read, - for standard input";
    }
    for (const Field& field : operation.fields) verb.options.push_back(flag_of(field));
    return verb;
}

Verb run_verb() {
    return {"run", "the steps of a job file, with the names of the verbs and their options",
            "JOB.json", "the job to read, - for standard input", flags_in(run_flags()), {}};
}

std::vector<Verb> verbs() {
    std::vector<Verb> all;
    for (const Operation& operation : operations()) all.push_back(verb_of(operation));
    all.push_back(run_verb());
    return all;
}

}  // namespace batten::cli
