"use strict";

// Shows what was run, and the command.

function showOverview(report) {
  const scenario = report.scenario;
  document.title = `${scenario.name}: Polhode report`;
  byId("scenario-name").textContent = scenario.name;
  byId("scenario-description").textContent = scenario.description || "";
  byId("made-by").textContent = `Polhode ${report.version}`;

  const list = (numbers, digits = 6) => numbers.map(number => shortNumber(number, digits)).join(", ");
  const facts = [
    ["time step dt", `${shortNumber(scenario.dt, 6)} s`],
    ["duration", `${shortNumber(scenario.duration, 6)} s`],
    ["steps", String(report.steps)],
    ["principal moments of inertia", `${list(report.inertia_B)} kg m\u00b2`],
    ["Bullet's precision", report.precision],
    ["Polhode", report.version],
  ];
  const acts = numbers => Array.isArray(numbers) && numbers.some(number => number !== 0);
  if (acts(scenario.gravity)) facts.push(["gravity", `${list(scenario.gravity)} m/s\u00b2`]);
  if (acts(scenario.torque)) facts.push(["torque", `${list(scenario.torque)} N m`]);
  if (scenario.torque_law) facts.push(["torque law", scenario.torque_law.kind.replaceAll("_", " ")]);
  if (scenario.rotor_momentum) {
    facts.push(["rotors at the start", `${list(scenario.rotor_momentum)} kg m\u00b2/s in body axes`]);
  }
  if (scenario.rotor_torque) facts.push(["motors of the rotors", `${scenario.rotor_torque.length} torques in turn`]);
  if (scenario.constraint) facts.push(["joint", "point to point"]);
  if (report.ground) facts.push(["ground", `at height ${shortNumber(report.ground.height, 6)} m`]);
  if (scenario.others && scenario.others.length > 0) {
    facts.push(["other bodies", `${scenario.others.length}, not recorded and not drawn`]);
  }
  if (report.note) facts.push(["contenders", report.note]);
  byId("rotor-hint").hidden = !report.hasRotors;
  byId("facts").replaceChildren(...facts.map(([term, text]) =>
    element("div", {}, element("dt", {}, term), element("dd", {}, text))));

  byId("command").textContent = report.command;
  byId("copy-command").addEventListener("click", copyCommand);
}

async function copyCommand() {
  const button = byId("copy-command");
  try {
    await navigator.clipboard.writeText(byId("command").textContent);
    button.textContent = "Copied";
  } catch {
    // Some browsers do not let a page from a file write to the clipboard: the text is selected for Ctrl+C instead.
    window.getSelection().selectAllChildren(byId("command"));
    button.textContent = "Selected";
  }
  setTimeout(() => { button.textContent = "Copy"; }, 2000);
}
