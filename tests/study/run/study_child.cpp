// Stands in for the icebow program where a study runs its designs in processes of their own. The name of a
// design says how it is to behave.
#include <signal.h>
#include <unistd.h>

#include <iostream>
#include <new>
#include <stdexcept>

#include "study/run/evaluate_design_child.h"
#include "tests/support/fake_study.h"

using namespace icebow;

namespace {

Evaluation misbehave(const Communicator& comm, const Design& design, const EvaluateOptions& options) {
  const std::string& name = design.name;
  if (name == "crash") {
    std::cerr << "about to crash" << std::endl;
    std::abort();
  }
  if (name == "exit") throw std::runtime_error("a message");
  if (name == "silent") _exit(0);
  if (name == "disk full") throw RuntimeError("cannot write history.csv: No space left on device");
  if (name == "no memory") throw std::bad_alloc();
  if (name.rfind("killed", 0) == 0) {
    const std::string mark = options.directory + "/../killed_before";
    const bool again = std::filesystem::exists(mark);
    write_text_file(mark, "");
    if (!again || name == "killed twice") kill(getpid(), SIGKILL);
  }
  if (name == "chatty") std::cout << "a library says hello" << std::endl;
  if (name == "pid") write_text_file(options.directory + "/pid.txt", std::to_string(getpid()));
  if (name == "pid" || name.rfind("hang", 0) == 0) {
    for (;;) pause();
  }
  const std::string checkpoint = options.directory + "/checkpoint.h5";
  const bool went_on = std::filesystem::exists(checkpoint);
  if (name == "slow" && !went_on) {
    write_text_file(checkpoint, "");
    sleep(5);
  }
  Evaluation e = fake_evaluate(comm, design, options);
  e.result["went_on"] = went_on;
  e.result["ranks"] = comm.size();
  return e;
}

}  // namespace

int main(int argc, char** argv) {
  MpiSession mpi(argc, argv);
  const Communicator world = mpi.world();
  if (argc < 2 || std::string(argv[1]) != "evaluate-design") return 3;
  return evaluate_design_child(world, std::vector<std::string>(argv + 2, argv + argc), misbehave);
}
