#include "study/run/evaluate_design_child.h"

#include <csignal>
#include <iostream>
#include <map>

#include "base/error_words.h"
#include "base/errors.h"
#include "base/stop_signal.h"
#include "study/evaluate/progress_json.h"

namespace icebow {
namespace {

constexpr const char* usage = "usage: icebow evaluate-design --design-json FILE --out DIR --result FILE";

std::map<std::string, std::string> parse(const std::vector<std::string>& arguments) {
  std::map<std::string, std::string> options = {{"--design-json", ""}, {"--out", ""}, {"--result", ""}};
  if (arguments.size() != 2 * options.size()) throw InputError(usage);
  for (std::size_t i = 0; i < arguments.size(); i += 2) {
    const auto option = options.find(arguments[i]);
    if (option == options.end() || !option->second.empty()) throw InputError(usage);
    option->second = arguments[i + 1];
  }
  return options;
}

// The root reads the file, so the other ranks need not see it. A mistake is everybody's.
Design received_design(const Communicator& comm, const std::string& path) {
  Json message = Json::object();
  if (comm.is_root()) {
    try {
      message["design"] = read_json_file(path);
    } catch (const InputError& error) {
      message["error"] = error.what();
    }
  }
  message = Json::parse(comm.broadcast(json_text(message)));
  if (message.contains("error")) throw InputError(message.at("error").get<std::string>());
  return design_from_json(message.at("design"));
}

// False where it was interrupted: its checkpoint is there.
bool evaluate_to_file(const Communicator& comm, const std::map<std::string, std::string>& options,
                      const EvaluateFunction& evaluator) {
  const Design design = received_design(comm, options.at("--design-json"));
  EvaluateOptions evaluate_options;
  evaluate_options.directory = options.at("--out");
  evaluate_options.on_progress = [](const Progress& p) { std::cout << progress_line(p) << std::endl; };
  evaluate_options.keep_checkpoint = true;  // until the study has stored the result
  evaluate_options.stop = StopSignal::raised;
  evaluate_options.checkpoint_now = StopSignal::checkpoint_asked;
  const Evaluation e = evaluator(comm, design, evaluate_options);
  if (e.status == EvaluationStatus::running) return false;
  std::string trouble;
  if (comm.is_root()) {
    try {
      write_text_file(options.at("--result"), json_text(to_json(e)));
    } catch (const RuntimeError& error) {
      trouble = error.what();
    }
  }
  fail_together(comm, trouble);
  return true;
}

}  // namespace

int evaluate_design_child(const Communicator& comm, const std::vector<std::string>& arguments,
                          const EvaluateFunction& evaluator) {
  // The parent ends a child by SIGTERM. Until there is a simulation, which asks for it, that is at once.
  const StopSignal signals(comm.is_root() ? StopSignal::Unheeded::ends : StopSignal::Unheeded::waits);
  try {
    const bool ended = evaluate_to_file(comm, parse(arguments), evaluator ? evaluator : evaluate);
    return ended ? 0 : 128 + SIGTERM;
  } catch (const InputError& error) {  // the study has read the same: its file is not there any more
    if (comm.is_root()) std::cout << trouble_line(error.what()) << std::endl;
    if (comm.is_root()) std::cerr << error.what() << std::endl;
    return 2;
  } catch (const std::exception& error) {
    // The machine's trouble is every rank's; the disk may be full, so it is not told by the log alone.
    const bool machine = is_of_machine(error);
    if (machine && comm.is_root()) std::cout << trouble_line(in_words(error)) << std::endl;
    std::cerr << in_words(error) << std::endl;
    return machine ? machine_trouble_code : 1;
  }
}

}  // namespace icebow
