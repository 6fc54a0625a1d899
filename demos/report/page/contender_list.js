"use strict";

// The list of contenders. Each can be hidden in all views and plots.

class ContenderList extends EventTarget {
  constructor(report) {
    super();
    this.report = report;
    this.boxes = report.contenders.map(contender => this.addBox(contender));
    byId("show-all").addEventListener("click", () => this.setAll(true));
    byId("show-none").addEventListener("click", () => this.setAll(false));
  }

  addBox(contender) {
    const box = element("input", {type: "checkbox", autocomplete: "off"});
    box.checked = true;
    box.addEventListener("change", () => {
      contender.visible = box.checked;
      this.dispatchEvent(new Event("change"));
    });
    const name = element("span", {class: "name", title: contender.summary}, contender.name);
    byId("contender-list").append(element("label", {}, box, palette.swatch(contender.number), name));
    return box;
  }

  setAll(visible) {
    this.boxes.forEach((box, number) => {
      box.checked = visible;
      this.report.contenders[number].visible = visible;
    });
    this.dispatchEvent(new Event("change"));
  }
}
