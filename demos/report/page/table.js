"use strict";

// The table of figures, as polhode_compare prints it, and what its columns mean.

function showFigures(report) {
  const headings = report.columns.map(({heading}) => heading.split("\n"));
  const head = element("tr", {}, element("th", {scope: "col"}, "contender"),
    ...report.columns.map(({meaning}, i) => element("th", {scope: "col", title: meaning},
      element("span", {}, headings[i][0] + " "), element("span", {}, headings[i][1]))));
  const rows = report.contenders.map(({name, number, cells}) => element("tr", {},
    element("th", {scope: "row"}, palette.swatch(number), element("span", {class: "name"}, name)),
    ...cells.map(cell => element("td", {}, cell))));
  byId("figures").replaceChildren(element("thead", {}, head), element("tbody", {}, ...rows));
  fillDescriptions(byId("figures-meaning"), [
    ...report.columns.map(({meaning}, i) => [headings[i].join(" "), meaning]),
    ["E", "total mechanical energy of the body: rotational, translational and potential, which is zero at the height of the "
      + "world's origin, without that of rotors inside the body; E0 at the start"],
    ["L", "angular momentum about the centre of mass, including that of rotors; L0 at the start. If forces, a torque law, "
      + "motors, a joint or a ground act on the body, energy and L change in the exact motion too"],
  ]);
  fillDescriptions(byId("summaries"), report.contenders.map(({name, summary}) => [name, summary || "-"]));
}

/** Hidden contenders keep a faint row, so that their figures can still be compared. */
function showHidden(report) {
  const rows = byId("figures").tBodies[0].rows;
  report.contenders.forEach(({visible}, number) => rows[number].classList.toggle("is-hidden", !visible));
}
