#include "record/series.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "record/errors.h"

namespace polhode::demos {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Calls visit(quantity, component) for each value of a record.
template <class Visit>
void for_each_component(const Visit& visit) {
  for (const Quantity& quantity : quantities()) {
    if (!quantity.is_in_report()) continue;
    for (int i = 0; i < quantity.components; ++i) visit(quantity, i);
  }
}

}  // namespace

SeriesRecorder::SeriesRecorder(const Vector3& inertia_B, double dt, std::int64_t steps,
                               std::size_t most_records)
    : inertia_B_(inertia_B), dt_(dt) {
  const auto most = static_cast<std::int64_t>(most_records);
  series_.stride = std::max<std::int64_t>(1, (steps + most - 1) / most);
}

void SeriesRecorder::add(const Sample& sample) {
  if (!start_) {
    start_ = sample;
    add_to_stretch(sample);
    end_stretch();
    return;
  }
  add_to_stretch(sample);
  if (is_past_cut(sample, dt_)) ++past_cut_;
  ++steps_in_stretch_;
  if (steps_in_stretch_ == series_.stride) end_stretch();
}

Series SeriesRecorder::finish() {
  if (steps_in_stretch_ > 0) end_stretch();
  return std::move(series_);
}

void SeriesRecorder::add_to_stretch(const Sample& sample) {
  const Instant at{sample, *start_, inertia_B_};
  std::vector<double> record;
  record.reserve(record_.size());
  for_each_component([&](const Quantity& quantity, int component) {
    const double value = quantity.value(at, component).value_or(kUnknown);
    const double before = steps_in_stretch_ > 0 ? record_[record.size()] : kUnknown;
    record.push_back(quantity.is_error() && std::abs(before) >= std::abs(value) ? before : value);
  });
  record_ = std::move(record);
}

void SeriesRecorder::end_stretch() {
  auto value = record_.begin();
  for_each_component([&](const Quantity& quantity, int /*component*/) {
    series_.columns[quantity.key].push_back(static_cast<float>(*value++));
  });
  series_.past_cut.push_back(static_cast<float>(past_cut_));
  steps_in_stretch_ = 0;
  past_cut_ = 0;
}

}  // namespace polhode::demos
