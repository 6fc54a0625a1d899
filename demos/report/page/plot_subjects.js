"use strict";

// What the plots are about. Of each: a line for every contender, or for one contender a line for each body axis.
//   magnitude: its absolute value is drawn on a logarithmic axis
//   cut: a linear axis ends at some multiples of the energy at the start, which one contender that blows up would flatten
//   absent: what is said where nobody has a number

const kNoForce = "Not known in this scenario: there is an exact motion to compare with only where no torque acts on a "
  + "body that is alone.";
const kNoEnergy = "Not defined in this scenario: the energy is 0 at the start.";
const kNoMomentum = "Not defined in this scenario: the angular momentum is 0 at the start.";

const kSubjects = [
  {id: "energy-error", title: "Energy error", key: "energy_error", magnitude: true,
    axis: "|E/E\u2080 \u2212 1|, no unit", absent: kNoEnergy,
    text: "How far the total energy is from that at the start, relative to it."},
  {id: "attitude-error", title: "Attitude error", key: "attitude_error_rad", magnitude: true,
    axis: "attitude error, rad", absent: kNoForce,
    text: "The angle between the orientation and the exact one. \u03c0 is the largest there is: such a contender is lost."},
  {id: "energy", title: "Total energy", key: "energy_J", cut: true, axis: "E, J", absent: "Not known.",
    text: "Rotational, translational, and potential with zero at the height of the world's origin."},
  {id: "energy-axes", title: "Energy about the body's axes", byAxis: true, cut: true, axis: "rotational energy, J",
    absent: "Not known for this contender.",
    text: "Half of I \u03c9\u00b2 about each principal axis: how a tumbling body hands its energy from axis to axis."},
  {id: "momentum-error", title: "Size of the angular momentum", key: "momentum_error", magnitude: true,
    axis: "| |L|/|L\u2080| \u2212 1 |, no unit", absent: kNoMomentum,
    text: "How far the length of L is from that at the start, relative to it."},
  {id: "momentum-angle", title: "Direction of the angular momentum", key: "momentum_angle_rad", magnitude: true,
    axis: "angle of L and L\u2080, rad", absent: kNoMomentum,
    text: "The angle by which L has turned away from its direction at the start."},
  {id: "det", title: "Determinant of R", key: "det_R", adaptive: true, axis: "det R, no unit", absent: "Not known.",
    text: "1 for a rotation; else the volume by which the matrix blows the body up."},
];

const kBodyAxes = ["x", "y", "z"];
const kAxisDashes = {x: [], y: [8, 4], z: [2, 3]};

/** The numbers of each contender by time index. */
function contenderLines(report, subject) {
  return report.contenders.map(contender => {
    const numbers = contender.series[subject.key];
    if (!subject.magnitude) return report.alongTimes(contender, record => numbers[record]);
    return report.alongTimes(contender, record => {
      const size = Math.abs(numbers[record]);
      return size < kLogFloor ? kLogFloor : size;  // a NaN stays one
    });
  });
}

/** The same of one contender, about each body axis. */
function axisLines(report, contender) {
  return kBodyAxes.map(axis => {
    const numbers = contender.series[`energy_${axis}_J`];
    return report.alongTimes(contender, record => numbers[record]);
  });
}

/** Where a linear axis ends at the latest. */
function cutOf(report, subject) {
  if (!subject.cut) return null;
  const start_J = report.contenders[0].series.energy_J[0];
  if (!(Math.abs(start_J) > 0)) return null;
  return [start_J - 2 * Math.abs(start_J), start_J + 2 * Math.abs(start_J)];
}
