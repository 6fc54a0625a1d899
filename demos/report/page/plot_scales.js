"use strict";

// Computes the ranges and marks of the plots' axes.

/** Zero, which has no logarithm, is drawn here. */
const kLogFloor = 1e-17;

/** Returns whole decades around all visible numbers. */
function logRange(low, high) {
  if (!(high > 0)) return [kLogFloor, 1];
  const from = Math.floor(Math.log10(low) + 1e-9);
  const to = Math.ceil(Math.log10(high) - 1e-9);
  return [10 ** from, 10 ** Math.max(to, from + 1)];
}

function logSplits(low, high, height) {
  const from = Math.round(Math.log10(low));
  const to = Math.round(Math.log10(high));
  const most = Math.max(2, Math.floor(height / 20));
  const every = [1, 2, 3, 4, 5, 6, 8, 10, 20, 50].find(decades => (to - from) / decades <= most) || 100;
  const splits = [];
  for (let exponent = every * Math.ceil(from / every); exponent <= to; exponent += every) splits.push(10 ** exponent);
  return splits;
}

/** Returns the range of a linear axis with a margin; a constant is shown as a line in the middle. */
function linearRange(low, high) {
  if (!(high >= low)) return [0, 1];
  const middle = 0.5 * (low + high);
  const isFlat = high - low <= 1e-6 * Math.abs(middle);
  const room = isFlat ? 0.02 * Math.abs(middle) || 1 : 0.06 * (high - low);
  return [low - room, high + room];
}

/** Returns the least and the greatest number of all lists, without null. */
function extent(lists) {
  let low = Infinity;
  let high = -Infinity;
  for (const list of lists) {
    for (const value of list) {
      if (value === null || value === undefined) continue;
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  return [low, high];
}

function linearTexts(splits) {
  return splits.map(value => shortNumber(value, 6));
}

function logTexts(splits) {
  return splits.map(value => powerOfTen(Math.round(Math.log10(value))));
}
