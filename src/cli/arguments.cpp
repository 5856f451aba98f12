#include "cli/arguments.h"

#include <algorithm>

#include "base/errors.h"
#include "study/spec/spec_hints.h"

namespace icebow {
namespace {

[[noreturn]] void usage_error(const Command& command, const std::string& message) {
  throw InputError("icebow " + command.name + ": " + message + " (see `icebow help " + command.name + "`)");
}

const Option& find_option(const Command& command, const std::string& name) {
  std::vector<std::string> known = {"--help"};
  for (const Option& option : command.options) {
    if (option.name == name) return option;
    known.push_back(option.name);
  }
  usage_error(command, "unknown option " + name + did_you_mean(name, known));
}

// Takes one option and its value off the words; returns the index of the last word used.
std::size_t take_option(const Command& command, const std::vector<std::string>& words, std::size_t i,
                        Arguments& arguments) {
  const std::size_t equals = words[i].find('=');
  const Option& option = find_option(command, words[i].substr(0, equals));
  std::vector<std::string>& given = arguments.options[option.name];
  if (!given.empty() && !option.repeats) usage_error(command, option.name + " is given twice");
  if (option.value.empty()) {
    if (equals != std::string::npos) usage_error(command, option.name + " takes no value");
    given.push_back("");
  } else if (equals != std::string::npos) {
    given.push_back(words[i].substr(equals + 1));
  } else if (i + 1 < words.size()) {
    given.push_back(words[++i]);
  } else {
    usage_error(command, option.name + " needs a value: " + option.name + " " + option.value);
  }
  return i;
}

void check_complete(const Command& command, const Arguments& arguments) {
  if (arguments.positional.empty()) usage_error(command, command.positional + " is missing");
  for (const Option& option : command.options) {
    if (!option.required || !arguments.value(option.name).empty()) continue;
    usage_error(command, option.name + " " + option.value + " is missing: " + option.meaning);
  }
}

std::string padded(const std::string& text, std::size_t width) {
  return text + std::string(width > text.size() ? width - text.size() : 1, ' ');
}

}  // namespace

std::string Arguments::value(const std::string& option) const {
  const auto given = options.find(option);
  return given == options.end() || given->second.empty() ? "" : given->second.back();
}

std::vector<std::string> Arguments::values(const std::string& option) const {
  const auto given = options.find(option);
  return given == options.end() ? std::vector<std::string>{} : given->second;
}

const Command& find_command(const std::string& name) {
  std::vector<std::string> known = {"help"};
  for (const Command& command : commands()) {
    if (command.name == name) return command;
    known.push_back(command.name);
  }
  throw InputError("icebow: unknown command " + name + did_you_mean(name, known) + "; there are " +
                   listed(known));
}

Arguments parse_arguments(const Command& command, const std::vector<std::string>& words) {
  Arguments arguments;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i].size() > 1 && words[i][0] == '-') {
      i = take_option(command, words, i, arguments);
    } else if (arguments.positional.empty()) {
      arguments.positional = words[i];
    } else {
      usage_error(command, "takes one " + command.positional + ", but " + words[i] + " is a second");
    }
  }
  check_complete(command, arguments);
  return arguments;
}

std::string help_text() {
  std::string text =
      "icebow: parametric studies of icebreaker bows\n\n"
      "usage: icebow COMMAND ... [options], also under mpirun\n\n";
  for (const Command& command : commands()) {
    text += "  " + padded(command.name + " " + command.positional, 18) + command.summary + "\n";
  }
  text +=
      "\n  icebow help COMMAND  options of a command\n  icebow --version\n\n"
      "A study file describes the ship, the ice and what to vary: see docs/study_file.md.\n"
      "Exit codes: 0 ok, 1 failure, 2 bad input, 3 some designs failed, 130 interrupted.\n";
  return text;
}

std::string help_text(const Command& command) {
  std::string usage = "usage: icebow " + command.name + " " + command.positional, table;
  for (const Option& option : command.options) {
    const std::string shown = option.name + (option.value.empty() ? "" : " " + option.value);
    usage += option.required ? " " + shown : " [" + shown + (option.repeats ? " ..." : "") + "]";
    table += "  " + padded(shown, 26) + option.meaning + "\n";
  }
  return usage + "\n\n" + command.details + "\n\n" + table;
}

}  // namespace icebow
