// One number per particle, in fp32 or fp64 as the run asks: the passes over all particles take the raw
// array of its type, everything else reads and writes doubles.
#pragma once

#include <cstddef>
#include <memory>

#include "solver/model/scenario.h"

namespace icebow {

// Zeroed, on a cache-line boundary. Fields that are walked together take different `stagger`s: arrays that
// all start at the same place of a page would compete for the same few cache sets.
class Field {
 public:
  class Reference {
   public:
    operator double() const { return field_.get(i_); }
    const Reference& operator=(double value) const {
      field_.set(i_, value);
      return *this;
    }
    const Reference& operator=(const Reference& other) const { return *this = double(other); }
    Reference(const Reference&) = default;

   private:
    friend class Field;
    Reference(Field& field, std::size_t i) : field_(field), i_(i) {}
    Field& field_;
    std::size_t i_;
  };

  Field(std::size_t n, Precision precision, int stagger = 0);

  bool is_fp64() const { return fp64_; }
  std::size_t element_size() const { return fp64_ ? sizeof(double) : sizeof(float); }
  std::byte* bytes() { return data_; }
  const std::byte* bytes() const { return data_; }
  // Real must be the field's own type.
  template <class Real>
  Real* data() {
    return reinterpret_cast<Real*>(data_);
  }
  template <class Real>
  const Real* data() const {
    return reinterpret_cast<const Real*>(data_);
  }

  double get(std::size_t i) const { return fp64_ ? data<double>()[i] : double(data<float>()[i]); }
  void set(std::size_t i, double value) {
    if (fp64_) {
      data<double>()[i] = value;
    } else {
      data<float>()[i] = static_cast<float>(value);
    }
  }
  double operator[](std::size_t i) const { return get(i); }
  Reference operator[](std::size_t i) { return {*this, i}; }

 private:
  struct Free {
    void operator()(std::byte* p) const;
  };
  bool fp64_;
  std::unique_ptr<std::byte, Free> memory_;
  std::byte* data_;
};

}  // namespace icebow
