"use strict";

// What the plots are about: the plots of the data, each with the numbers of its quantity. Of one number there is a line for
// every contender, of a vector, for one contender, a line for each body axis.

const kBodyAxes = ["x", "y", "z"];
const kAxisDashes = {x: [], y: [8, 4], z: [2, 3]};

/** The numbers of a quantity by time index, as they are drawn; of a vector those along an axis. */
function lineOf(report, contender, subject, axis = 0) {
  return report.alongTimes(contender, record => {
    const value = contender.value(subject.key, record, axis);
    if (!subject.is_logarithmic) return value;
    const size = Math.abs(value);
    return size < kLogFloor ? kLogFloor : size;  // a NaN stays one
  });
}

/**
 * Where a linear axis ends at the latest: energies at some multiples of that at the start, which one contender that blows up
 * would flatten.
 */
function cutOf(report, subject) {
  if (subject.unit !== "J") return null;
  const start_J = report.contenders[0].series.energy_J[0];
  if (!(Math.abs(start_J) > 0)) return null;
  return [start_J - 2 * Math.abs(start_J), start_J + 2 * Math.abs(start_J)];
}
