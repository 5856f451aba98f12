// A study in which too many designs fail is stopped before it is paid for.
#pragma once

#include <string>

#include "study/evaluate/evaluation.h"

namespace icebow {

class FailureRate {
 public:
  // `limit`: the part of the designs that may fail; 0 = all of them.
  explicit FailureRate(double limit) : limit_(limit) {}

  // Of what was evaluated now; what the store had is judged already.
  void count(const Evaluation& evaluation);
  // In words where more failed than may, of five designs or more; else empty.
  std::string too_many() const;

 private:
  double limit_;
  int evaluated_ = 0, failed_ = 0;
  std::string last_;
};

}  // namespace icebow
