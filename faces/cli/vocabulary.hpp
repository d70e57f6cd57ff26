#pragma once

#include <string>
#include <variant>
#include <vector>

#include "batten/api/operation.hpp"
#include "command_line.hpp"

namespace batten::cli {

/// `weight_exponent` as `weight-exponent`.
std::string flag_name(const std::string& field);

/// One flag as it is typed; help, man page and completions are made from these.
struct Flag {
    std::string name;   ///< without the dashes
    char letter = 0;    ///< the short name, if there is one
    std::string takes;  ///< what follows it; empty where nothing does
    std::string help;
    std::vector<std::string> choices = {};
    bool takes_file = false;
};

/// A flag that every verb has, and where its value goes.
struct CommonFlag {
    Flag flag;
    std::variant<std::string Command::*, bool Command::*> member;
};

/// Flags about files and messages. A verb has those that make sense for its input and output.
std::vector<CommonFlag> common_flags(const Operation& operation);

/// The flags of the verb `run`.
std::vector<CommonFlag> run_flags();

/// The flag of an operation's option.
Flag flag_of(const Field& field);

/// A verb of the command, from the operations table.
struct Verb {
    std::string name;
    std::string help;
    std::string input;  ///< `POINTS`, `FILE…`, or nothing
    std::string input_help;
    std::vector<Flag> common;
    std::vector<Flag> options;
};

Verb verb_of(const Operation& operation);

/// `batten run JOB.json`.
Verb run_verb();

/// All of them, in the order of the table.
std::vector<Verb> verbs();

/// One sentence about the whole, and what all verbs have in common.
extern const char* const about;
extern const char* const habits;

}  // namespace batten::cli
