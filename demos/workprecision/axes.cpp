#include "workprecision/axes.h"

#include <cmath>

namespace polhode::demos {

namespace {

// Returns the position of value i along the axis, from 0 to 1.
double part(std::int64_t i, std::int64_t count) {
  return static_cast<double>(i) / static_cast<double>(count - 1);
}

}  // namespace

double LogarithmicAxis::at(std::int64_t i) const {
  if (i == 0) return from;
  if (i == count - 1) return to;  // avoids rounding
  return from * std::pow(to / from, part(i, count));
}

double LinearAxis::at(std::int64_t i) const {
  if (i == 0) return from;
  if (i == count - 1) return to;  // avoids rounding
  return from + (to - from) * part(i, count);
}

}  // namespace polhode::demos
