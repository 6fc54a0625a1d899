#pragma once

#include <cstring>

#include "simd/instruction_sets.h"
#include "simd/wide.h"

/// Gathers rows of numbers, one row for each body, from memory into wide numbers, and scatters them back.
/// `row_of(lane)` returns a pointer to the first number of a row.
namespace polhode {

/// Three numbers for each of eight bodies.
template <class Number>
struct WideRows {
  using Some = BasicWide<RegistersOf<Number>>;

  Some x, y, z;
};

/// Four numbers for each of eight bodies.
template <class Number>
struct WideRowsOfFour {
  using Some = BasicWide<RegistersOf<Number>>;

  Some x, y, z, w;
};

#if defined(POLHODE_SHUFFLES)

// Takes half the time of moving the numbers one by one.
template <class Number>
class ShuffledRows {
 public:
  typedef Number Row __attribute__((vector_size(4 * sizeof(Number))));
  using Some = BasicWide<RegistersOf<Number>>;
  using Values = typename Some::Values;

  template <class RowOf>
  static POLHODE_INLINE WideRowsOfFour<Number> load(RowOf row_of) {
    Row rows[kLanes];  // std::array would lose the attribute
    for (std::size_t lane = 0; lane < kLanes; ++lane) std::memcpy(&rows[lane], row_of(lane), sizeof(Row));
    const Values rows_04 = __builtin_shufflevector(rows[0], rows[4], 0, 1, 2, 3, 4, 5, 6, 7);
    const Values rows_15 = __builtin_shufflevector(rows[1], rows[5], 0, 1, 2, 3, 4, 5, 6, 7);
    const Values rows_26 = __builtin_shufflevector(rows[2], rows[6], 0, 1, 2, 3, 4, 5, 6, 7);
    const Values rows_37 = __builtin_shufflevector(rows[3], rows[7], 0, 1, 2, 3, 4, 5, 6, 7);
    const Values xy_0145 = __builtin_shufflevector(rows_04, rows_15, 0, 8, 1, 9, 4, 12, 5, 13);
    const Values xy_2367 = __builtin_shufflevector(rows_26, rows_37, 0, 8, 1, 9, 4, 12, 5, 13);
    const Values zw_0145 = __builtin_shufflevector(rows_04, rows_15, 2, 10, 3, 11, 6, 14, 7, 15);
    const Values zw_2367 = __builtin_shufflevector(rows_26, rows_37, 2, 10, 3, 11, 6, 14, 7, 15);
    return {Some(__builtin_shufflevector(xy_0145, xy_2367, 0, 1, 8, 9, 4, 5, 12, 13)),
            Some(__builtin_shufflevector(xy_0145, xy_2367, 2, 3, 10, 11, 6, 7, 14, 15)),
            Some(__builtin_shufflevector(zw_0145, zw_2367, 0, 1, 8, 9, 4, 5, 12, 13)),
            Some(__builtin_shufflevector(zw_0145, zw_2367, 2, 3, 10, 11, 6, 7, 14, 15))};
  }

  // Each element holds the rows of two lanes, `lane` and `lane` + 4.
  struct Pairs {
    Values of[kLanes / 2];

    POLHODE_INLINE explicit Pairs(const WideRowsOfFour<Number>& columns) {
      const Values& x = columns.x.values();
      const Values& y = columns.y.values();
      const Values& z = columns.z.values();
      const Values& w = columns.w.values();
      const Values xy_0145 = __builtin_shufflevector(x, y, 0, 8, 1, 9, 4, 12, 5, 13);
      const Values xy_2367 = __builtin_shufflevector(x, y, 2, 10, 3, 11, 6, 14, 7, 15);
      const Values zw_0145 = __builtin_shufflevector(z, w, 0, 8, 1, 9, 4, 12, 5, 13);
      const Values zw_2367 = __builtin_shufflevector(z, w, 2, 10, 3, 11, 6, 14, 7, 15);
      of[0] = __builtin_shufflevector(xy_0145, zw_0145, 0, 1, 8, 9, 4, 5, 12, 13);
      of[1] = __builtin_shufflevector(xy_0145, zw_0145, 2, 3, 10, 11, 6, 7, 14, 15);
      of[2] = __builtin_shufflevector(xy_2367, zw_2367, 0, 1, 8, 9, 4, 5, 12, 13);
      of[3] = __builtin_shufflevector(xy_2367, zw_2367, 2, 3, 10, 11, 6, 7, 14, 15);
    }
  };

  // Stores the first `bytes` of each row.
  template <std::size_t bytes, class RowOf>
  static POLHODE_INLINE void store(const WideRowsOfFour<Number>& columns, RowOf row_of) {
    const Pairs pairs(columns);
    for (std::size_t lane = 0; lane < kLanes / 2; ++lane) {
      const Row low = __builtin_shufflevector(pairs.of[lane], pairs.of[lane], 0, 1, 2, 3);
      const Row high = __builtin_shufflevector(pairs.of[lane], pairs.of[lane], 4, 5, 6, 7);
      std::memcpy(row_of(lane), &low, bytes);
      std::memcpy(row_of(lane + kLanes / 2), &high, bytes);
    }
  }

  // Stores two consecutive rows for each lane.
  template <class RowOf>
  static POLHODE_INLINE void store_two(const WideRowsOfFour<Number>& first,
                                       const WideRowsOfFour<Number>& second, RowOf row_of) {
    const Pairs a(first);
    const Pairs b(second);
    for (std::size_t lane = 0; lane < kLanes / 2; ++lane) {
      const Values low = __builtin_shufflevector(a.of[lane], b.of[lane], 0, 1, 2, 3, 8, 9, 10, 11);
      const Values high = __builtin_shufflevector(a.of[lane], b.of[lane], 4, 5, 6, 7, 12, 13, 14, 15);
      std::memcpy(row_of(lane), &low, sizeof(Values));
      std::memcpy(row_of(lane + kLanes / 2), &high, sizeof(Values));
    }
  }
};

#endif

/// Gathers rows of four numbers.
template <class Number, class RowOf>
POLHODE_INLINE WideRowsOfFour<Number> gather_rows_of_four(RowOf row_of) {
#if defined(POLHODE_SHUFFLES)
  if (is_one_register(kLanes * sizeof(Number))) return ShuffledRows<Number>::load(row_of);
#endif
  WideRowsOfFour<Number> result = {Number(0.0), Number(0.0), Number(0.0), Number(0.0)};
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const Number* row = row_of(lane);
    result.x.set(lane, row[0]);
    result.y.set(lane, row[1]);
    result.z.set(lane, row[2]);
    result.w.set(lane, row[3]);
  }
  return result;
}

template <std::size_t numbers, class Number, class RowOf>
POLHODE_INLINE void scatter_first_of_rows(const WideRowsOfFour<Number>& columns, RowOf row_of) {
#if defined(POLHODE_SHUFFLES)
  if (is_one_register(kLanes * sizeof(Number))) {
    ShuffledRows<Number>::template store<numbers * sizeof(Number)>(columns, row_of);
    return;
  }
#endif
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    Number* row = row_of(lane);
    row[0] = columns.x[lane];
    row[1] = columns.y[lane];
    row[2] = columns.z[lane];
    if (numbers == 4) row[3] = columns.w[lane];
  }
}

template <class Number, class RowOf>
POLHODE_INLINE void scatter_rows_of_four(const WideRowsOfFour<Number>& columns, RowOf row_of) {
  scatter_first_of_rows<4>(columns, row_of);
}

/// Gathers the first three numbers of each row of four. The fourth must be readable.
template <class Number, class RowOf>
POLHODE_INLINE WideRows<Number> gather_rows(RowOf row_of) {
  const WideRowsOfFour<Number> rows = gather_rows_of_four<Number>(row_of);
  return {rows.x, rows.y, rows.z};
}

/// Scatters rows of four and sets the fourth number to zero.
template <class Number, class RowOf>
POLHODE_INLINE void scatter_rows(const WideRows<Number>& columns, RowOf row_of) {
  scatter_rows_of_four(WideRowsOfFour<Number>{columns.x, columns.y, columns.z, Number(0.0)}, row_of);
}

/// Does the same for two consecutive rows for each lane.
template <class Number, class RowOf>
POLHODE_INLINE void scatter_two_rows(const WideRows<Number>& first, const WideRows<Number>& second,
                                     RowOf row_of) {
#if defined(POLHODE_SHUFFLES)
  if (is_one_register(kLanes * sizeof(Number))) {
    ShuffledRows<Number>::store_two({first.x, first.y, first.z, Number(0.0)},
                                    {second.x, second.y, second.z, Number(0.0)}, row_of);
    return;
  }
#endif
  scatter_rows(first, row_of);
  scatter_rows(second, [&](std::size_t lane) { return row_of(lane) + 4; });
}

/// Scatters rows of three and does not write the memory behind them.
template <class Number, class RowOf>
POLHODE_INLINE void scatter_rows_of_three(const WideRows<Number>& columns, RowOf row_of) {
  scatter_first_of_rows<3>(WideRowsOfFour<Number>{columns.x, columns.y, columns.z, Number(0.0)}, row_of);
}

}  // namespace polhode
