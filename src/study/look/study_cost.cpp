#include "study/look/study_cost.h"

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>

#include "base/errors.h"
#include "study/evaluate/evaluate.h"

namespace icebow {
namespace {

namespace fs = std::filesystem;

// Steps of a voyage over those of its first seconds: ice that is broken follows the full bond law, and its
// pieces push each other. Measured: docs/study_file.md, "What a study takes".
constexpr double later_steps = 3.0;
constexpr double row_bytes = 30e3;  // of the store: two thirds of them are cracks and floes
constexpr double formula_row_bytes = 3e3;
constexpr double bytes_of_snapshot = 36.0;  // a particle
constexpr double bytes_of_state = 110.0;  // a particle, of a checkpoint: bond bits, displacements, velocities

class Scratch {
 public:
  Scratch() {
    std::string pattern = (fs::temp_directory_path() / "icebow_cost_XXXXXX").string();
    if (!mkdtemp(pattern.data())) throw RuntimeError(pattern + ": no directory for a moment can be made");
    path = pattern;
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  std::string path;
};

double size_of(const fs::path& file) {
  std::error_code none;
  const auto size = fs::file_size(file, none);
  return none ? 0.0 : static_cast<double>(size);
}

double size_of_all(const std::string& directory) {
  double sum = 0.0;
  for (const auto& entry : fs::recursive_directory_iterator(directory))
    if (entry.is_regular_file() && entry.path().filename() != checkpoint_name) sum += size_of(entry.path());
  return sum;
}

struct Measured {
  Evaluation evaluation;
  Progress last;       // of the simulation
  double began = 0.0;  //!< seconds of CPU before its first step
  double cpu = 0.0;    //!< all of it [s]
};

double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

Measured measure(const Design& design, const std::string& directory, double seconds) {
  Measured m;
  EvaluateOptions options;
  options.directory = directory;
  options.on_progress = [&](const Progress& p) { m.last = p; };
  const double begin = cpu_seconds();
  options.stop = [&] {
    if (m.began == 0.0) m.began = cpu_seconds();
    return cpu_seconds() - m.began > seconds;
  };
  m.evaluation = evaluate(Communicator::serial(), design, options);
  m.cpu = cpu_seconds() - begin;
  m.began = m.began > 0.0 ? m.began - begin : m.cpu;
  return m;
}

// Its pictures and their animation, its snapshots.
double bytes_to_come(const Case& c, const std::string& directory, double particles) {
  const double picture = size_of(fs::path(directory) / "ice_000.png");
  return 2.0 * picture * std::max(0, c.pictures - 1) + bytes_of_snapshot * particles * c.snapshots;
}

double particles_of(const Case& c) {
  const double dx = c.numerics.dx;
  return c.sheet.length * c.sheet.width * c.ice.h / (dx * dx * dx) * (c.sheet.half_model ? 0.5 : 1.0);
}

void count(StudyCost& cost, const StudySpec& spec, const StudyPlan& plan) {
  cost.designs =
      static_cast<int>(plan.designs.size()) + plan.proposals * (spec.use_peridynamics ? spec.repeats : 1);
  cost.confirmations = (spec.confirm.best + spec.confirm.spread) * spec.repeats;
}

// Throws what is in the way, in words.
DesignCost cost_of(const Design& design, double seconds) {
  const Scratch scratch;
  const Measured m = measure(design, design.asked.formula_alone() ? "" : scratch.path, seconds);
  const bool over = m.evaluation.status == EvaluationStatus::ok;
  if (!over && m.evaluation.status != EvaluationStatus::running)
    throw RuntimeError("the file's own design has no result: " + m.evaluation.reason);
  if (!over && design.asked.peridynamics && m.last.step == 0)
    throw RuntimeError("not one step of the file's own design was simulated within the time");
  DesignCost cost;
  cost.core_s = m.cpu;
  cost.bytes = design.asked.formula_alone() ? formula_row_bytes : row_bytes + size_of_all(scratch.path);
  if (!design.asked.peridynamics || over) return cost;
  const double particles = particles_of(*design.given);
  const auto steps = static_cast<double>(m.last.steps), done = static_cast<double>(m.last.step);
  cost.core_s = m.began + (m.cpu - m.began) / done * steps * later_steps;
  cost.bytes += bytes_to_come(*design.given, scratch.path, particles);
  cost.checkpoint = bytes_of_state * particles;
  return cost;
}

}  // namespace

StudyCost design_cost(const StudySpec& spec, Design design, double seconds) {
  StudyCost cost;
  cost.designs = spec.use_peridynamics ? spec.repeats : 1;
  cost.confirmations = spec.confirm.given() ? spec.repeats : 0;
  cost.programs = !design.asked.programs.empty();
  design.asked.programs.clear();
  if (spec.confirm.given()) design.asked.peridynamics = false;
  try {
    cost.design = cost_of(design, seconds);
    design.asked.peridynamics = true;
    if (spec.confirm.given()) cost.confirmation = cost_of(design, seconds);
  } catch (const RuntimeError& error) {
    cost.unknown = error.what();
  }
  return cost;
}

StudyCost study_cost(const StudySpec& spec, const StudyPlan& plan, double seconds) {
  StudyCost cost = design_cost(spec, baseline_of(spec), seconds);
  count(cost, spec, plan);
  return cost;
}

}  // namespace icebow
