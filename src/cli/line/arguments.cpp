#include "cli/line/arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <stdexcept>

#include "base/errors.h"
#include "study/spec/spec_hints.h"

namespace icebow {
namespace {

[[noreturn]] void usage_error(const Command& command, const std::string& message) {
  throw InputError("icebow " + command.name + ": " + message + " (see `icebow help " + command.name + "`)");
}

const Option* find_option(const Command& command, const std::string& name) {
  const auto found = std::find_if(command.options.begin(), command.options.end(),
                                  [&](const Option& option) { return option.name == name; });
  return found == command.options.end() ? nullptr : &*found;
}

// Names of the words that stand for themselves.
std::pair<std::string, std::string> positionals(const Command& command) {
  const std::size_t space = command.positional.find(' ');
  if (space == std::string::npos) return {command.positional, ""};
  return {command.positional.substr(0, space), command.positional.substr(space + 1)};
}

// What CLI11 did not know what to do with.
[[noreturn]] void refuse_surplus(const Command& command, const std::vector<std::string>& surplus) {
  const auto is_option = [](const std::string& word) { return word.size() > 1 && word[0] == '-'; };
  const auto unknown = std::find_if(surplus.begin(), surplus.end(), is_option);
  const bool two = command.positional.find(' ') != std::string::npos;
  if (unknown == surplus.end())
    usage_error(command, "takes one " + command.positional + ", but " + surplus.front() + " is a " +
                             (two ? "third word" : "second"));
  std::vector<std::string> known = {"--help"};
  for (const Option& option : command.options) known.push_back(option.name);
  const std::string name = unknown->substr(0, unknown->find('='));
  usage_error(command, "unknown option " + name + did_you_mean(name, known));
}

// CLI11's words begin with the option: "--design: 1 required TEXT missing", "json was given a disallowed
// ...".
[[noreturn]] void refuse_value(const Command& command, const CLI::ParseError& error) {
  const std::string words = error.what();
  const std::string name = words.substr(0, words.find_first_of(": "));
  const Option* const option = find_option(command, name[0] == '-' ? name : "--" + name);
  if (!option) usage_error(command, words);
  if (option->value.empty()) usage_error(command, option->name + " takes no value");
  usage_error(command, option->name + " needs a value: " + option->name + " " + option->value);
}

void check_complete(const Command& command, const Arguments& arguments) {
  const auto [first, second] = positionals(command);
  if (arguments.positional.empty()) usage_error(command, first + " is missing");
  if (!second.empty() && arguments.second.empty()) usage_error(command, second + " is missing");
  for (const Option& option : command.options) {
    if (arguments.values(option.name).size() > 1 && !option.repeats)
      usage_error(command, option.name + " is given twice");
    if (option.required && arguments.value(option.name).empty())
      usage_error(command, option.name + " " + option.value + " is missing: " + option.meaning);
  }
}

}  // namespace

const std::vector<std::string>& Arguments::values(const std::string& option) const {
  const auto given = options.find(option);
  if (given == options.end()) throw std::logic_error("this command has no option " + option);
  return given->second;
}

bool Arguments::has(const std::string& option) const {
  return !values(option).empty();
}

std::string Arguments::value(const std::string& option) const {
  return has(option) ? values(option).back() : "";
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
  CLI::App parser;
  parser.set_help_flag();
  parser.allow_extras();
  const auto [first, second] = positionals(command);
  parser.add_option(first, arguments.positional);
  if (!second.empty()) parser.add_option(second, arguments.second);
  for (const Option& option : command.options) {
    std::vector<std::string>& given = arguments.options[option.name];
    if (option.value.empty()) {
      parser.add_flag(option.name, given)->disable_flag_override();
    } else {
      parser.add_option(option.name, given)->allow_extra_args(false);
    }
  }
  try {
    parser.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::ParseError& error) {
    refuse_value(command, error);
  }
  if (!parser.remaining().empty()) refuse_surplus(command, parser.remaining());
  check_complete(command, arguments);
  return arguments;
}

}  // namespace icebow
