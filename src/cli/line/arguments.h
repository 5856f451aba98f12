// The command line of the program: which commands and options there are, and what a user gave.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/communicator.h"

namespace icebow {

struct Option {
  std::string name;   // "--out"
  std::string value;  // what to call its value in the help; empty = a switch
  std::string meaning;
  bool required = false;
  bool repeats = false;
};

class Arguments {
 public:
  std::string positional;  // the study file or directory
  std::string second;      // "DIR DESIGN": the other word; empty where the command takes one
  std::map<std::string, std::vector<std::string>> options;  // all of the command's; empty where not given
  std::string command_line;                                 // as typed

  // Each throws std::logic_error for an option that the command does not have.
  bool has(const std::string& option) const;
  std::string value(const std::string& option) const;  // the last one given; empty where none
  const std::vector<std::string>& values(const std::string& option) const;
};

struct Command {
  std::string name;
  std::string positional;  // "STUDY", "DIR", or two words: "DIR DESIGN"
  std::string summary;     // one line
  std::string details;     // for `icebow help NAME`; a line end begins a new paragraph
  std::string example;     // a call that works as it stands
  std::vector<Option> options;
  // Collective commands are entered by every rank; of the others only the root takes part.
  bool collective = false;
  int (*run)(const Communicator&, const Arguments&) = nullptr;  // returns the exit code
};

const std::vector<Command>& commands();
// Throws InputError naming the nearest known command.
const Command& find_command(const std::string& name);

// `words` are those behind the command's name. Throws InputError: unknown option (with the nearest known
// one), a value or a required option that is missing, too many words.
Arguments parse_arguments(const Command& command, const std::vector<std::string>& words);

}  // namespace icebow
