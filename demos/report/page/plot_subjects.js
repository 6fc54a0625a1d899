"use strict";

// The subjects of the plots: each has the numbers of one quantity. A scalar has a line for every contender; a vector has a
// line for each body axis, of one contender.

const kBodyAxes = ["x", "y", "z"];
const kAxisDashes = {x: [], y: [8, 4], z: [2, 3]};

/** Returns the numbers of a quantity by time index, as they are drawn; for a vector those along an axis. */
function lineOf(report, contender, subject, axis = 0) {
  return report.alongTimes(contender, record => {
    const value = contender.value(subject.key, record, axis);
    if (!subject.is_logarithmic) return value;
    const size = Math.abs(value);
    return size < kLogFloor ? kLogFloor : size;  // NaN stays NaN
  });
}

/**
 * Returns the limits of a linear axis: a few multiples of the initial energy, so that one contender that blows up does not
 * flatten the others.
 */
function cutOf(report, subject) {
  if (subject.unit !== "J") return null;
  const start_J = report.contenders[0].series.energy_J[0];
  if (!(Math.abs(start_J) > 0)) return null;
  return [start_J - 2 * Math.abs(start_J), start_J + 2 * Math.abs(start_J)];
}
