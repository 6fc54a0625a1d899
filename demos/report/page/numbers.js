"use strict";

// Formats numbers: in the table as polhode_compare prints them, on axes as powers of ten.

/** Formats like C's %g with this number of significant digits; "-" if there is no number. */
function shortNumber(value, digits) {
  if (value === null || value === undefined || Number.isNaN(value)) return "-";
  if (!Number.isFinite(value)) return value > 0 ? "inf" : "-inf";
  if (value === 0) return "0";
  const [mantissa, power] = value.toExponential(digits - 1).split("e");
  const exponent = Number(power);
  if (exponent >= -4 && exponent < digits) return withoutTrailingZeros(value.toFixed(digits - 1 - exponent));
  const magnitude = String(Math.abs(exponent)).padStart(2, "0");
  return withoutTrailingZeros(mantissa) + "e" + (exponent < 0 ? "-" : "+") + magnitude;
}

/** Does the same with a + before positive numbers. */
function signedNumber(value, digits) {
  return (value > 0 ? "+" : "") + shortNumber(value, digits);
}

function withoutTrailingZeros(text) {
  return text.includes(".") ? text.replace(/\.?0+$/, "") : text;
}

/** Formats a whole power of ten, for the axis of a logarithmic plot. */
function powerOfTen(exponent) {
  const superscripts = {"-": "\u207b", 0: "\u2070", 1: "\u00b9", 2: "\u00b2", 3: "\u00b3", 4: "\u2074", 5: "\u2075",
    6: "\u2076", 7: "\u2077", 8: "\u2078", 9: "\u2079"};
  if (exponent === 0) return "1";
  return "10" + Array.from(String(exponent), digit => superscripts[digit]).join("");
}

function unitText(unit) {
  return unit === "1" ? "no unit" : unit;
}

/** Formats a time with as many decimals as the distance of two records requires. */
function timeText(t_s, distance_s) {
  if (t_s !== 0 && (Math.abs(t_s) >= 1e7 || distance_s < 1e-7)) return shortNumber(t_s, 7);
  const decimals = distance_s > 0 ? Math.min(7, Math.max(0, Math.ceil(-Math.log10(distance_s)))) : 3;
  return t_s.toFixed(decimals);
}
