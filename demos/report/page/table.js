"use strict";

// The table of figures, as polhode_compare prints it, and what its columns mean.

const kColumns = [
  [["final", "E/E0-1"], figures => signedNumber(figures.final_energy_error, 4),
    "relative change of the energy at the end, with its sign: below 0 energy was lost"],
  [["worst", "|E/E0-1|"], figures => shortNumber(figures.worst_energy_error, 3), "its largest magnitude at any step"],
  [["worst", "|L| error"], figures => shortNumber(figures.worst_momentum_error, 3), "largest ||L|/|L0| - 1|"],
  [["turn of", "L, rad"], figures => shortNumber(figures.worst_momentum_angle_rad, 3),
    "largest angle between L and L at the start, rad"],
  [["attitude", "end, rad"], figures => shortNumber(figures.final_attitude_error_rad, 3),
    "attitude error at the end: the angle between the orientation and the exact one, rad; \"-\": that is not known"],
  [["attitude", "max, rad"], figures => shortNumber(figures.worst_attitude_error_rad, 3),
    "the largest attitude error, rad"],
  [["final", "det R"], figures => shortNumber(figures.final_det_R, 6),
    "1 for a rotation; the volume by which a swollen basis blows the body up"],
  [["fast", "steps"], figures => shortNumber(figures.steps_past_cut, 17),
    "steps after which |omega| dt > pi/4, where Bullet turns less than the velocity it reports"],
  [["diverged", "at t, s"], figures => shortNumber(figures.diverged_at_s, 6),
    "end of the step that failed; \"-\": none did"],
  [["ns per", "step"], figures => shortNumber(Math.trunc(figures.ns_per_step), 17),
    "wall-clock time of stepSimulation, median of the steps, with some 50 ns for reading the clock; it depends on the "
    + "machine and its mood"],
];

function showFigures(report) {
  const title = ([first, second]) => [element("span", {}, first + " "), element("span", {}, second)];
  const head = element("tr", {}, element("th", {scope: "col"}, "contender"),
    ...kColumns.map(([lines, , meaning]) => element("th", {scope: "col", title: meaning}, ...title(lines))));
  const rows = report.contenders.map(({name, number, figures}) => element("tr", {},
    element("th", {scope: "row"}, palette.swatch(number), element("span", {class: "name"}, name)),
    ...kColumns.map(([, cell]) => element("td", {}, cell(figures)))));
  byId("figures").replaceChildren(element("thead", {}, head), element("tbody", {}, ...rows));
  fillDescriptions(byId("figures-meaning"), [
    ...kColumns.map(([lines, , meaning]) => [lines.join(" "), meaning]),
    ["E", "total mechanical energy of the body: rotational, translational, and potential with zero at the height of the "
      + "world's origin, without that of rotors inside the body; E0 at the start"],
    ["L", "angular momentum about the centre of mass, with that of rotors; L0 at the start. Where forces, a torque law, "
      + "motors, a joint or a ground act on the body, energy and L may rightly change"],
  ]);
  fillDescriptions(byId("summaries"), report.contenders.map(({name, summary}) => [name, summary || "-"]));
}

/** Hidden contenders keep their row, faintly: the figures are to be compared. */
function showHidden(report) {
  const rows = byId("figures").tBodies[0].rows;
  report.contenders.forEach(({visible}, number) => rows[number].classList.toggle("is-hidden", !visible));
}
