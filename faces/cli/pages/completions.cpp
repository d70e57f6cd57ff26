#include <utility>

#include "pages.hpp"
#include "cli/vocabulary.hpp"

namespace batten::cli {
namespace {

/// `text` between single quotes, for any shell of the three; `doubled` is how the shell writes a
/// quote inside.
std::string quoted(const std::string& text, const char* inner) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string(inner) : std::string(1, c);
    return result + '\'';
}

std::string posix_quoted(const std::string& text) { return quoted(text, "'\\''"); }
std::string fish_quoted(const std::string& text) {
    std::string escaped;
    for (const char c : text) escaped += c == '\\' ? std::string("\\\\") : std::string(1, c);
    return quoted(escaped, "\\'");
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
    return text;
}

std::vector<Flag> all_flags(const Verb& verb) {
    std::vector<Flag> flags = verb.options;
    flags.insert(flags.end(), verb.common.begin(), verb.common.end());
    flags.push_back({"help", 'h', "", "print this help"});
    return flags;
}

std::string flag_words(const Verb& verb) {
    std::vector<std::string> words;
    for (const Flag& flag : all_flags(verb)) words.push_back("--" + flag.name);
    return joined(words);
}

std::string verb_words() {
    std::vector<std::string> words;
    for (const Verb& verb : verbs()) words.push_back(verb.name);
    return joined(words);
}

/// `[text]` as zsh's _arguments takes it.
std::string zsh_text(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
        result += c;
    }
    return result;
}

std::string zsh_flag(const Flag& flag) {
    std::string text = "--" + flag.name + '[' + zsh_text(flag.help) + ']';
    if (flag.takes.empty()) return text;
    text += ':' + zsh_text(flag.takes) + ':';
    if (!flag.choices.empty()) return text + '(' + joined(flag.choices) + ')';
    return text + (flag.takes_file ? "_files" : " ");
}

}  // namespace

std::string bash_completion() {
    std::string flags, values;
    for (const Verb& verb : verbs()) {
        flags += "        " + verb.name + ") flags=" + posix_quoted(flag_words(verb)) + " ;;\n";
        for (const Flag& flag : all_flags(verb)) {
            if (flag.choices.empty()) continue;
            values += "        '" + verb.name + " --" + flag.name + "') words=" +
                      posix_quoted(joined(flag.choices)) + " ;;\n";
        }
    }
    return "# bash completion for batten\n"
           "_batten() {\n"
           "    local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}\n"
           "    local verb=${COMP_WORDS[1]} flags= words=\n"
           "    COMPREPLY=()\n"
           "    if [ \"$COMP_CWORD\" = 1 ]; then\n"
           "        COMPREPLY=($(compgen -W '" + verb_words() + " --help --version' -- \"$current\"))\n"
           "        return\n"
           "    fi\n"
           "    case \"$verb $before\" in\n" + values +
           "    esac\n"
           "    case \"$verb\" in\n" + flags +
           "    esac\n"
           "    if [ -n \"$words\" ]; then\n"
           "        COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
           "    elif [ \"${current#-}\" != \"$current\" ]; then\n"
           "        COMPREPLY=($(compgen -W \"$flags\" -- \"$current\"))\n"
           "    else\n"
           "        COMPREPLY=($(compgen -f -- \"$current\"))\n"
           "    fi\n"
           "}\n"
           "complete -o filenames -F _batten batten\n";
}

std::string zsh_completion() {
    std::string names, cases;
    for (const Verb& verb : verbs()) {
        names += "        " + posix_quoted(verb.name + ":" + verb.help) + '\n';
        cases += "        " + verb.name + ")\n            _arguments \\\n";
        for (const Flag& flag : all_flags(verb)) {
            cases += "                " + posix_quoted(zsh_flag(flag)) + " \\\n";
        }
        cases += "                '*:" + zsh_text(verb.input) + ":_files' ;;\n";
    }
    return "#compdef batten\n"
           "_batten() {\n"
           "    local -a verbs\n"
           "    verbs=(\n" + names +
           "    )\n"
           "    if (( CURRENT == 2 )); then\n"
           "        _describe verb verbs\n"
           "        return\n"
           "    fi\n"
           "    local verb=$words[2]\n"
           "    shift words\n"
           "    (( CURRENT-- ))\n"
           "    case $verb in\n" + cases +
           "    esac\n"
           "}\n"
           "_batten \"$@\"\n";
}

std::string fish_completion() {
    std::string text = "# fish completion for batten\n"
                       "complete -c batten -n __fish_use_subcommand -l version -d 'print the version'\n";
    for (const Verb& verb : verbs()) {
        text += "complete -c batten -f -n __fish_use_subcommand -a " + verb.name + " -d " +
                fish_quoted(verb.help) + '\n';
        for (const Flag& flag : all_flags(verb)) {
            text += "complete -c batten -n '__fish_seen_subcommand_from " + verb.name + "' -l " +
                    flag.name;
            if (flag.letter) text += std::string(" -s ") + flag.letter;
            if (!flag.choices.empty()) {
                text += " -x -a " + fish_quoted(joined(flag.choices));
            } else if (!flag.takes.empty()) {
                text += flag.takes_file ? " -r" : " -x";
            }
            text += " -d " + fish_quoted(flag.help) + '\n';
        }
    }
    return text;
}

}  // namespace batten::cli
