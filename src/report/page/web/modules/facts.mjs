import { element } from "./dom.mjs";
import { figure } from "./numbers.mjs";

/// {rows: [{name, value, unit, digits, note}]}: figures that are read first.
export function facts(section) {
  return element("dl", { class: "facts" }, section.rows.map((row) => element("div", {},
    element("dt", {}, row.name),
    element("dd", {}, typeof row.value === "string" ? row.value : figure(row.value, row.unit, row.digits),
      row.note ? element("small", {}, row.note) : null))));
}
