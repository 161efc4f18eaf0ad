import { element } from "./dom.mjs";
import { numberText } from "./numbers.mjs";

/// {columns: [{name, unit, digits}], rows: [[number or text]], note}
export function table(section) {
  const isNumber = section.columns.map((_, i) => section.rows.some((row) => typeof row[i] === "number"));
  const side = (i) => ({ class: isNumber[i] ? "number" : undefined });
  const head = section.columns.map((column, i) => element("th", { scope: "col", ...side(i) },
    column.unit ? `${column.name}, ${column.unit}` : column.name));
  const body = section.rows.map((row) => element("tr", {}, row.map((value, i) => element("td", side(i),
    typeof value === "number" ? numberText(value, section.columns[i].digits) : value ?? ""))));
  const wide = element("div", { class: "wide", tabindex: 0, role: "region", "aria-label": section.title },
    element("table", {}, element("thead", {}, element("tr", {}, head)), element("tbody", {}, body)));
  return element("div", {}, section.note ? element("p", { class: "note" }, section.note) : null, wide);
}
