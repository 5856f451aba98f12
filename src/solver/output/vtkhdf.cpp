#include "solver/output/vtkhdf.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <numeric>

#include "base/errors.h"
#include "base/json.h"
#include "base/parallel_file.h"
#include "solver/output/interleaved.h"

namespace icebow {
namespace {

constexpr std::uint8_t vtk_vertex = 1;

std::vector<std::int64_t> of_all_ranks(const Communicator& comm, std::int64_t value) {
  std::vector<std::int64_t> values(comm.size(), 0);
  values[comm.rank()] = value;
  comm.sum(values.data(), comm.size());
  return values;
}

// Arrays that the ranks' parts fill one after the other.
class Parts {
 public:
  Parts(const Communicator& comm, ParallelFile& file, std::int64_t own)
      : counts_(of_all_ranks(comm, own)), rank_(comm.rank()), file_(file) {}

  const std::vector<std::int64_t>& counts() const { return counts_; }

  template <class T>
  void write(const std::string& name, const std::vector<T>& values) {
    write(name, values, 0, 0);
  }
  template <class T>
  void write_with_one_more_each(const std::string& name, const std::vector<T>& values) {
    write(name, values, 0, 1);
  }
  void write_vectors(const std::string& name, const std::vector<float>& x, const std::vector<float>& y,
                     const std::vector<float>& z) {
    write(name, interleaved(x, y, z), 3, 0);
  }

 private:
  template <class T>
  void write(const std::string& name, const std::vector<T>& values, std::uint64_t components, int more) {
    std::uint64_t total = 0, start = 0;
    for (std::size_t r = 0; r < counts_.size(); ++r) {
      if (static_cast<int>(r) == rank_) start = total;
      total += counts_[r] + more;
    }
    const std::uint64_t own = counts_[rank_] + more;
    Slab there{{total}, {start}, {own}}, here = Slab::whole({own});
    if (components > 0) {
      there = {{total, components}, {start, 0}, {own, components}};
      here = Slab::whole({own, components});
    }
    file_.write(name, there, values.data(), here);
  }

  std::vector<std::int64_t> counts_;
  int rank_;
  ParallelFile& file_;
};

void write_grid(const Communicator& comm, ParallelFile& file, const IceCloud& own, bool cracks) {
  const std::int64_t n = own.x.size();
  std::vector<std::int64_t> upwards(n + 1);
  std::iota(upwards.begin(), upwards.end(), 0);
  file.group("/VTKHDF");
  file.attribute("/VTKHDF", "Version", std::vector<std::int64_t>{1, 0});
  file.attribute("/VTKHDF", "Type", "UnstructuredGrid");
  Parts parts(comm, file, n);
  for (const char* count : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"})
    file.write_list(std::string("/VTKHDF/") + count, parts.counts());
  parts.write_vectors("/VTKHDF/Points", own.x, own.y, own.z);
  parts.write_with_one_more_each("/VTKHDF/Offsets", upwards);
  upwards.pop_back();
  parts.write("/VTKHDF/Connectivity", upwards);
  parts.write("/VTKHDF/Types", std::vector<std::uint8_t>(n, vtk_vertex));
  file.group("/VTKHDF/PointData");
  parts.write_vectors("/VTKHDF/PointData/displacement_m", own.ux, own.uy, own.uz);
  if (!own.vx.empty()) parts.write_vectors("/VTKHDF/PointData/velocity_m_per_s", own.vx, own.vy, own.vz);
  parts.write("/VTKHDF/PointData/damage", own.damage);
  parts.write("/VTKHDF/PointData/piece", own.piece);
  if (cracks) parts.write("/VTKHDF/PointData/crack", own.crack);
}

}  // namespace

void write_ice_vtkhdf(const Communicator& comm, const std::string& path, const IceCloud& own, bool cracks) {
  const std::string temporary = path + ".tmp";
  try {
    ParallelFile file = ParallelFile::create(comm, temporary);
    write_grid(comm, file, own, cracks);
    file.close();
  } catch (const RuntimeError&) {
    if (comm.is_root()) std::remove(temporary.c_str());
    throw;
  }
  std::string trouble;
  if (comm.is_root() && std::rename(temporary.c_str(), path.c_str()) != 0)
    trouble = "cannot replace " + path + ": " + std::strerror(errno);
  fail_together(comm, trouble);
}

void write_series(const std::string& path, const std::vector<std::pair<double, std::string>>& steps) {
  Json files = Json::array();
  for (const auto& [time, file] : steps) files.push_back({{"name", file}, {"time", time}});
  write_text_file(path, Json({{"file-series-version", "1.0"}, {"files", files}}).dump(1) + "\n");
}

}  // namespace icebow
