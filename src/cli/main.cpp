// The program `icebow`: parse, dispatch, catch.
#include <csignal>
#include <cstdlib>
#include <iostream>

#include "base/error_words.h"
#include "base/errors.h"
#include "base/printable.h"
#include "cli/commands.h"
#include "cli/line/help_text.h"
#include "cli/line/version_text.h"
#include "solver/kernel/kernel.h"
#include "study/run/evaluate_design_child.h"
#include "study/run/run_study.h"
#include "study/spec/spec_hints.h"

namespace icebow {
namespace {

int print_help(const std::vector<std::string>& words, bool is_root) {
  const std::string completion = "--completion=";
  std::string text;
  if (words.empty()) {
    text = help_text();
  } else if (words[0] == "--man") {
    text = man_page();
  } else if (words[0].rfind(completion, 0) == 0) {
    text = completion_script(words[0].substr(completion.size()));
  } else {
    text = help_text(find_command(words[0]));
  }
  if (is_root) std::cout << text;
  return exit_code::ok;
}

// A command of the root alone: its exceptions must not leave the other ranks waiting for the exit code.
int run_on_root(const Command& command, const Communicator& comm, const Arguments& arguments) {
  int code = exit_code::ok;
  std::string bad_input, failure;
  try {
    if (comm.is_root()) code = command.run(comm, arguments);
  } catch (const InputError& error) {
    bad_input = error.what();
  } catch (const std::exception& error) {
    failure = in_words(error);
  }
  comm.broadcast(&code, sizeof code);
  bad_input = comm.broadcast(bad_input);
  failure = comm.broadcast(failure);
  if (!bad_input.empty()) throw InputError(bad_input);
  if (!failure.empty()) throw RuntimeError(failure);
  return code;
}

int dispatch(const Communicator& comm, const std::vector<std::string>& words) {
  if (words.empty() || words[0] == "--help" || words[0] == "-h") return print_help({}, comm.is_root());
  if (words[0] == "--version") {
    const std::string text = version_text();
    if (comm.is_root()) std::cout << text;
    return exit_code::ok;
  }
  const std::vector<std::string> rest(words.begin() + 1, words.end());
  if (words[0] == "help") return print_help(rest, comm.is_root());
  if (words[0] == "evaluate-design") return evaluate_design_child(comm, rest);  // started by `icebow run`
  if (words[0].rfind("-", 0) == 0) {
    throw InputError("icebow: unknown option " + words[0] + did_you_mean(words[0], {"--help", "--version"}));
  }
  const Command& command = find_command(words[0]);
  for (const std::string& word : rest) {
    if (word == "--help" || word == "-h") return print_help({words[0]}, comm.is_root());
  }
  Arguments arguments = parse_arguments(command, rest);
  arguments.command_line = "icebow";
  for (const std::string& word : words) arguments.command_line += " " + word;
  kernels();  // a vector width that cannot be had is refused before anything is done
  return command.collective ? command.run(comm, arguments) : run_on_root(command, comm, arguments);
}

// InputError and RuntimeError are thrown by every rank or by none; any other exception may be this rank's
// alone, and then leaving without MPI's farewell is what ends the others.
int guarded(const Communicator& comm, const std::vector<std::string>& words) {
  try {
    const int code = dispatch(comm, words);
    std::cout.flush();
    if (!std::cout) throw RuntimeError("cannot write to standard output");
    return code;
  } catch (const InputError& error) {
    if (comm.is_root()) std::cerr << printable(error.what()) << std::endl;
    return exit_code::bad_input;
  } catch (const RuntimeError& error) {
    if (comm.is_root()) std::cerr << printable(error.what()) << std::endl;
    return exit_code::failure;
  } catch (const std::exception& error) {
    std::cerr << "icebow: rank " << comm.rank() << ": " << printable(in_words(error)) << std::endl;
    if (comm.size() > 1) std::_Exit(exit_code::failure);
    return exit_code::failure;
  }
}

}  // namespace
}  // namespace icebow

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // beyond a limit on file sizes a write then fails, which is told in words
  const icebow::MpiSession mpi(argc, argv);
  const icebow::Communicator world = mpi.world();
  return icebow::guarded(world, std::vector<std::string>(argv + 1, argv + argc));
}
