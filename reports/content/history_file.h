// history.csv of one design, thinned for a chart.
#pragma once

#include <string>
#include <vector>

namespace icebow {

struct LoadSeries {
  std::vector<double> advance;  //!< [m]
  std::vector<double> load;     //!< resistance, -Fx [N]
  std::size_t samples = 0;      // rows of the file
};

// Columns are found by name (advance_m, Fx_N). Empty where the file is missing or has no such columns; rows
// that cannot be read are left out. Values are multiplied by the factors given (model to full scale).
LoadSeries read_load_series(const std::string& csv_path, double length_factor, double force_factor);

// At most `most` points: the lowest and the highest of each bin, in their order, so that every peak stays.
LoadSeries thinned(const LoadSeries& series, std::size_t most);

}  // namespace icebow
