#include "bench/machine.h"

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/communicator_native.h"
#include "solver/kernel/kernel.h"

namespace icebow {
namespace {

// Value of the first line "key : value", empty where there is none.
std::string cpuinfo(const std::string& key) {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(':');
    if (line.compare(0, key.size(), key) == 0 && colon != std::string::npos && colon + 2 <= line.size())
      return line.substr(colon + 2);
  }
  return "";
}

std::string processor() {
  const std::string name = cpuinfo("model name");
  if (name.empty()) return "unknown";
  // Virtual machines hide the model behind a general name: family and model say which it is.
  return name + " (family " + cpuinfo("cpu family") + ", model " + cpuinfo("model\t") + ")";
}

std::vector<int> usable_cpus() {
  std::vector<int> cpus;
  cpu_set_t allowed;
  const bool known = !MpiSession::started_by_mpirun() && sched_getaffinity(0, sizeof allowed, &allowed) == 0;
  const int configured =
      static_cast<int>(std::min(sysconf(_SC_NPROCESSORS_CONF), static_cast<long>(CPU_SETSIZE)));
  const int online = static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN));
  for (int cpu = 0; cpu < configured; ++cpu) {
    if (known ? CPU_ISSET(cpu, &allowed) : cpu < online) cpus.push_back(cpu);
  }
  return cpus;
}

int topology(int cpu, const std::string& what, int otherwise) {
  std::ifstream file("/sys/devices/system/cpu/cpu" + std::to_string(cpu) + "/topology/" + what);
  int value;
  return file >> value ? value : otherwise;
}

int physical_cores(const std::vector<int>& cpus) {
  std::set<std::pair<int, int>> cores;
  for (const int cpu : cpus)
    cores.emplace(topology(cpu, "physical_package_id", 0), topology(cpu, "core_id", cpu));
  return static_cast<int>(cores.size());
}

std::string compiler() {
#if defined(__clang__)
  return "clang " __clang_version__;
#elif defined(__GNUC__)
  return "g++ " __VERSION__;
#else
  return "unknown";
#endif
}

std::string mpi_version() {
  char text[MPI_MAX_LIBRARY_VERSION_STRING];
  int length = 0;
  MPI_Get_library_version(text, &length);  // allowed before MPI_Init
  const std::string version(text, length);
  return version.substr(0, version.find_first_of(",\n"));
}

// Of the last minute: tells whether the machine was quiet.
double load_average() {
  double load = -1.0;
  getloadavg(&load, 1);
  return load;
}

std::string date() {
  const std::time_t now = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&now));
  return text;
}

}  // namespace

nlohmann::json machine_context() {
  const std::vector<int> cpus = usable_cpus();
  return {{"processor", processor()},
          {"physical_cores", physical_cores(cpus)},
          {"logical_cores", cpus.size()},
          {"compiler", compiler()},
          {"build_type", ICEBOW_BUILD_TYPE},
          {"flags", ICEBOW_FLAGS},
          {"kernel_flags", ICEBOW_KERNEL_FLAGS},
          {"kernel", kernels().name},
          {"kernel_bits", 8 * kernels().vector_bytes},
          {"mpi", mpi_version()},
          {"load_average", load_average()},
          {"date", date()}};
}

}  // namespace icebow
