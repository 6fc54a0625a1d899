#pragma once

#include <cstring>

#include "lanes/instruction_sets.h"
#include "lanes/lanes.h"

#if defined(__has_builtin) && defined(__GNUC__) && !defined(POLHODE_PLAIN_LANES)
#if __has_builtin(__builtin_shufflevector)
#define POLHODE_SHUFFLED_ROWS
#endif
#endif

namespace polhode {

/// Three numbers of each of eight bodies. In memory they are a row of four, of which the last is of no use.
template <class Number>
struct LaneRows {
  using Some = BasicLanes<RegistersOf<Number>>;

  Some x, y, z;
};

#if defined(POLHODE_SHUFFLED_ROWS)

// Half the time that it takes number by number.
template <class Number, class RowOf>
POLHODE_INLINE LaneRows<Number> load_rows_whole(RowOf row_of) {
  typedef Number Row __attribute__((vector_size(4 * sizeof(Number))));
  using Some = typename LaneRows<Number>::Some;
  using Values = typename Some::Values;
  Row rows[kLanes];  // std::array would lose the attribute
  for (std::size_t lane = 0; lane < kLanes; ++lane) std::memcpy(&rows[lane], row_of(lane), sizeof(Row));
  const Values rows_04 = __builtin_shufflevector(rows[0], rows[4], 0, 1, 2, 3, 4, 5, 6, 7);
  const Values rows_15 = __builtin_shufflevector(rows[1], rows[5], 0, 1, 2, 3, 4, 5, 6, 7);
  const Values rows_26 = __builtin_shufflevector(rows[2], rows[6], 0, 1, 2, 3, 4, 5, 6, 7);
  const Values rows_37 = __builtin_shufflevector(rows[3], rows[7], 0, 1, 2, 3, 4, 5, 6, 7);
  const Values xy_0145 = __builtin_shufflevector(rows_04, rows_15, 0, 8, 1, 9, 4, 12, 5, 13);
  const Values xy_2367 = __builtin_shufflevector(rows_26, rows_37, 0, 8, 1, 9, 4, 12, 5, 13);
  const Values z_0145 = __builtin_shufflevector(rows_04, rows_15, 2, 10, 3, 11, 6, 14, 7, 15);
  const Values z_2367 = __builtin_shufflevector(rows_26, rows_37, 2, 10, 3, 11, 6, 14, 7, 15);
  return {Some(__builtin_shufflevector(xy_0145, xy_2367, 0, 1, 8, 9, 4, 5, 12, 13)),
          Some(__builtin_shufflevector(xy_0145, xy_2367, 2, 3, 10, 11, 6, 7, 14, 15)),
          Some(__builtin_shufflevector(z_0145, z_2367, 0, 1, 8, 9, 4, 5, 12, 13))};
}

template <class Number, class RowOf>
POLHODE_INLINE void store_rows_whole(const LaneRows<Number>& columns, RowOf row_of) {
  typedef Number Row __attribute__((vector_size(4 * sizeof(Number))));
  using Values = typename LaneRows<Number>::Some::Values;
  const Values& x = columns.x.values();
  const Values& y = columns.y.values();
  const Values& z = columns.z.values();
  const Values zero = {};
  const Values xy_0145 = __builtin_shufflevector(x, y, 0, 8, 1, 9, 4, 12, 5, 13);
  const Values xy_2367 = __builtin_shufflevector(x, y, 2, 10, 3, 11, 6, 14, 7, 15);
  const Values z_0145 = __builtin_shufflevector(z, zero, 0, 8, 1, 9, 4, 12, 5, 13);
  const Values z_2367 = __builtin_shufflevector(z, zero, 2, 10, 3, 11, 6, 14, 7, 15);
  const Values pairs[] = {__builtin_shufflevector(xy_0145, z_0145, 0, 1, 8, 9, 4, 5, 12, 13),
                          __builtin_shufflevector(xy_0145, z_0145, 2, 3, 10, 11, 6, 7, 14, 15),
                          __builtin_shufflevector(xy_2367, z_2367, 0, 1, 8, 9, 4, 5, 12, 13),
                          __builtin_shufflevector(xy_2367, z_2367, 2, 3, 10, 11, 6, 7, 14, 15)};
  for (std::size_t lane = 0; lane < kLanes / 2; ++lane) {
    const Row low = __builtin_shufflevector(pairs[lane], pairs[lane], 0, 1, 2, 3);
    const Row high = __builtin_shufflevector(pairs[lane], pairs[lane], 4, 5, 6, 7);
    std::memcpy(row_of(lane), &low, sizeof(Row));
    std::memcpy(row_of(lane + kLanes / 2), &high, sizeof(Row));
  }
}

#endif

/// `row_of(lane)` points to the row's first number.
template <class Number, class RowOf>
POLHODE_INLINE LaneRows<Number> load_rows(RowOf row_of) {
#if defined(POLHODE_SHUFFLED_ROWS)
  if (is_one_register(kLanes * sizeof(Number))) return load_rows_whole<Number>(row_of);
#endif
  LaneRows<Number> result = {Number(0.0), Number(0.0), Number(0.0)};
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const Number* row = row_of(lane);
    result.x.set(lane, row[0]);
    result.y.set(lane, row[1]);
    result.z.set(lane, row[2]);
  }
  return result;
}

/// The fourth number of each row becomes zero.
template <class Number, class RowOf>
POLHODE_INLINE void store_rows(const LaneRows<Number>& columns, RowOf row_of) {
#if defined(POLHODE_SHUFFLED_ROWS)
  if (is_one_register(kLanes * sizeof(Number))) {
    store_rows_whole(columns, row_of);
    return;
  }
#endif
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    Number* row = row_of(lane);
    row[0] = columns.x[lane];
    row[1] = columns.y[lane];
    row[2] = columns.z[lane];
    row[3] = Number(0.0);
  }
}

}  // namespace polhode
