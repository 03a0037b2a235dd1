// error_sums: running maximum, mean and root mean square. Sums of up to 2^26 samples are compensated (Neumaier), so the last
// digits that are printed don't depend on the order in which triangles arrive.
#pragma once
#include <cmath>
#include <cstdint>

#include "tb/analysis/error.hpp"

namespace relievo::tb {

class compensated_sum {
 public:
  void add(double x) {
    const double next = sum_ + x;
    lost_ += std::abs(sum_) >= std::abs(x) ? (sum_ - next) + x : (x - next) + sum_;
    sum_ = next;
  }
  double value() const { return sum_ + lost_; }

 private:
  double sum_ = 0.0;
  double lost_ = 0.0;
};

class error_sums {
 public:
  void add(double error, int x, int y) {
    const double e = std::abs(error);
    ++count_;
    sum_.add(e);
    squares_.add(e * e);
    // Equal maxima: the first texel in row order, whichever triangle came first.
    if (e > max_ || (e == max_ && (y < worst_y_ || (y == worst_y_ && x < worst_x_))) || count_ == 1) {
      max_ = e;
      worst_x_ = x;
      worst_y_ = y;
    }
  }

  void fill(error_report& report, height_map const& map) const {
    report.samples = count_;
    if (count_ == 0) return;
    const double n = static_cast<double>(count_);
    report.world = {max_, std::sqrt(squares_.value() / n), sum_.value() / n};
    const double per_sample = map.scale == 0.0 ? 0.0 : 1.0 / std::abs(map.scale);
    const double per_metre = per_sample * std::abs(map.range_high - map.range_low) / 65535.0;
    report.in_samples = {report.world.max * per_sample, report.world.rms * per_sample, report.world.mean * per_sample};
    report.physical = {report.world.max * per_metre, report.world.rms * per_metre, report.world.mean * per_metre};
    report.worst_x = worst_x_;
    report.worst_y = worst_y_;
  }

 private:
  std::uint64_t count_ = 0;
  double max_ = 0.0;
  int worst_x_ = 0;
  int worst_y_ = 0;
  compensated_sum sum_;
  compensated_sum squares_;
};

}  // namespace relievo::tb
