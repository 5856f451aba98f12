#include "cli/line/help_text.h"

#include <algorithm>
#include <sstream>

#include "base/errors.h"
#include "base/shell_word.h"
#include "study/spec/spec_hints.h"

namespace icebow {
namespace {

constexpr std::size_t column = 26;  // where the meaning of an option begins

std::string padded(const std::string& text, std::size_t width) {
  return text + std::string(width > text.size() ? width - text.size() : 1, ' ');
}

std::string shown(const Option& option) {
  return option.name + (option.value.empty() ? "" : " " + option.value);
}

// "  --out DIR    directory of the study"; a long name has its meaning on the next line.
std::string table_line(const std::string& name, const std::string& meaning, std::size_t begin) {
  std::string head = "  " + padded(name, begin - 2);
  if (head.size() > begin) head += '\n' + std::string(begin, ' ');
  return head + wrapped(meaning, help_width - begin, begin) + '\n';
}

// Lines break between options, never inside one.
std::string usage_lines(const Command& command) {
  constexpr char joint = '\x1f';
  std::string usage = "usage: icebow " + command.name + " " + command.positional;
  for (const Option& option : command.options) {
    std::string word =
        option.required ? shown(option) : "[" + shown(option) + (option.repeats ? " ..." : "") + "]";
    std::replace(word.begin(), word.end(), ' ', joint);
    usage += ' ' + word;
  }
  usage = wrapped(usage, help_width - 7, 7);
  std::replace(usage.begin(), usage.end(), joint, ' ');
  return usage;
}

std::vector<std::string> paragraphs(const std::string& text) {
  std::vector<std::string> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) found.push_back(line);
  return found;
}

std::string option_names(const Command& command) {
  std::string names;
  for (const Option& option : command.options) names += option.name + ' ';
  return names + "--help";
}

std::string command_names() {
  std::string names;
  for (const Command& command : commands()) names += command.name + ' ';
  return names + "help";
}

std::string bash_completion() {
  std::string cases;
  for (const Command& command : commands())
    cases += "    " + command.name + ") options=" + shell_quoted(option_names(command)) + " ;;\n";
  return "# bash completion of icebow; written by `icebow help --completion=bash`\n"
         "_icebow() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} options=\n"
         "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
         "    COMPREPLY=($(compgen -W " +
         shell_quoted(command_names() + " --help --version") +
         " -- \"$word\"))\n"
         "    return\n  fi\n"
         "  case ${COMP_WORDS[1]} in\n" +
         cases + "    help) options=" + shell_quoted(command_names()) +
         " ;;\n  esac\n"
         "  case ${COMP_WORDS[1]}:$word in\n"
         "    help:* | *:-*) COMPREPLY=($(compgen -W \"$options\" -- \"$word\")) ;;\n"
         "    *) COMPREPLY=($(compgen -f -- \"$word\")) ;;\n"
         "  esac\n}\ncomplete -o filenames -F _icebow icebow\n";
}

std::string zsh_completion() {
  const auto described = [](std::string text) {
    for (std::size_t at = 0; (at = text.find_first_of("[]:'", at)) != std::string::npos; at += 1)
      text[at] = ' ';
    return text;
  };
  std::string list, cases;
  for (const Command& command : commands()) {
    list += "    " + shell_quoted(command.name + ":" + described(command.summary)) + "\n";
    cases += "  " + command.name + ")\n    _arguments";
    for (const Option& option : command.options)
      cases += " \\\n      '" + std::string(option.repeats ? "*" : "") + option.name + "[" +
               described(option.meaning) + "]" +
               (option.value.empty() ? "" : ":" + described(option.value) + ":_files") + "'";
    cases += " \\\n      '*:file:_files' ;;\n";
  }
  return "#compdef icebow\n# written by `icebow help --completion=zsh`\n"
         "local -a names\nif (( CURRENT == 2 )); then\n  names=(\n" +
         list +
         "  )\n  _describe command names\n  return\nfi\nlocal name=$words[2]\nshift words; (( CURRENT-- "
         "))\n" +
         "case $name in\n" + cases + "esac\n";
}

std::string fish_completion() {
  std::string text = "# fish completion of icebow; written by `icebow help --completion=fish`\n";
  for (const Command& command : commands()) {
    text += "complete -c icebow -f -n __fish_use_subcommand -a " + command.name + " -d " +
            shell_quoted(command.summary) + "\n";
    for (const Option& option : command.options)
      text += "complete -c icebow -n '__fish_seen_subcommand_from " + command.name + "' -l " +
              option.name.substr(2) + (option.value.empty() ? "" : " -r") + " -d " +
              shell_quoted(option.meaning) + "\n";
  }
  return text;
}

// roff takes a hyphen for a soft one and a dot at a line's begin for a request.
std::string roff(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '-') {
      out += "\\-";
    } else if (c == '\\') {
      out += "\\e";
    } else {
      out += c;
    }
  }
  return out.empty() || (out[0] != '.' && out[0] != '\'') ? out : "\\&" + out;
}

std::string man_command(const Command& command) {
  std::string text =
      ".SS icebow " + roff(command.name) + " " + command.positional + "\n" + roff(command.summary) + ".\n";
  for (const std::string& paragraph : paragraphs(command.details)) text += ".PP\n" + roff(paragraph) + "\n";
  for (const Option& option : command.options) {
    text += ".TP\n.B " + roff(option.name) +
            (option.value.empty() ? "" : " \\fI" + roff(option.value) + "\\fR") + "\n" +
            roff(option.meaning) + "\n";
  }
  return text + ".PP\nExample:\n.PP\n.EX\n" + roff(command.example) + "\n.EE\n";
}

constexpr const char* exit_codes =
    "Exit codes: 0 ok, 1 failure, 2 bad input, 3 some designs failed, 130 interrupted.";

}  // namespace

std::string wrapped(const std::string& text, std::size_t width, std::size_t indent) {
  std::istringstream words(text);
  std::string out;
  std::size_t used = 0;
  for (std::string word; words >> word; used += word.size()) {
    if (used > 0 && used + 1 + word.size() > width) {
      out += '\n' + std::string(indent, ' ');
      used = 0;
    } else if (used > 0) {
      out += ' ';
      ++used;
    }
    out += word;
  }
  return out;
}

std::string help_text() {
  std::string text =
      "icebow: parametric studies of icebreaker bows\n\n"
      "usage: icebow COMMAND ... [options], also under mpirun\n\n";
  for (const Command& command : commands())
    text += table_line(command.name + " " + command.positional, command.summary, 20);
  return text +
         "\n  icebow help COMMAND  options of a command, and an example\n  icebow --version\n\n"
         "A study file describes the ship, the ice and what to vary: see docs/study_file.md.\n"
         "`icebow new` writes a first one.\n" +
         exit_codes + "\n";
}

std::string help_text(const Command& command) {
  std::string text = usage_lines(command) + "\n\n";
  for (const std::string& paragraph : paragraphs(command.details))
    text += wrapped(paragraph, help_width, 0) + "\n";
  text += "\n";
  for (const Option& option : command.options) text += table_line(shown(option), option.meaning, column + 2);
  return text + "\nexample: " + command.example + "\n";
}

std::string man_page() {
  std::string text =
      ".\\\" written by `icebow help --man`\n.TH ICEBOW 1 \"\" \"icebow\" \"User Commands\"\n.SH NAME\n"
      "icebow \\- parametric studies of icebreaker bows\n.SH SYNOPSIS\n.B icebow\n.I COMMAND\n.RI [ options "
      "]\n"
      ".SH DESCRIPTION\n"
      "A study file describes the ship, the ice and what to vary. Icebow generates the bows, breaks level "
      "ice with "
      "them by the breaking cycle of ship simulators and by peridynamics, puts Lindqvist's formula beside "
      "both, and "
      "ranks the designs in one offline report. Each command also runs under mpirun.\n.SH COMMANDS\n";
  for (const Command& command : commands()) text += man_command(command);
  return text + ".SH EXIT STATUS\n" + roff(exit_codes) +
         "\n.SH ENVIRONMENT\n.TP\n.B ICEBOW_KERNEL\nvector width of the solver: baseline, avx2 or avx512; "
         "default: the "
         "widest of the processor\n.TP\n.B NO_COLOR\nno colours in the terminal\n"
         ".SH SEE ALSO\nThe documents in /usr/share/doc/icebow, first README.md.\n";
}

std::string completion_script(const std::string& shell) {
  if (shell == "bash") return bash_completion();
  if (shell == "zsh") return zsh_completion();
  if (shell == "fish") return fish_completion();
  throw InputError("icebow help --completion=" + shell + ": there are bash, zsh and fish" +
                   did_you_mean(shell, {"bash", "zsh", "fish"}));
}

}  // namespace icebow
