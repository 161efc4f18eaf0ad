import { bars } from "./bars.mjs";
import { circles } from "./circles.mjs";
import { curves } from "./curves.mjs";
import { element } from "./dom.mjs";
import { facts } from "./facts.mjs";
import { heat } from "./heat.mjs";
import { sheetWords } from "./paper.mjs";
import { polar } from "./polar.mjs";
import { program } from "./program.mjs";
import { table } from "./table.mjs";
import { listing, text, warnings } from "./text.mjs";

const kSections = { bars, circles, curves, facts, heat, listing, polar, program, table, text, warnings };

/// Builds the page of `data` (src/report/page/README.md) into `main`.
export function build(data, main) {
  document.title = data.title;
  main.append(element("h1", {}, data.title));
  if (data.lead) main.append(element("p", { class: `lead ${data.verdict ?? ""}` }, data.lead));
  for (const section of data.sections) {
    const box = element("section", { "aria-label": section.title, class: section.screen_only ? "screen-only" : undefined });
    if (section.title) box.append(element("h2", {}, section.title));
    main.append(box);
    box.append(kSections[section.type](section));
    if (section.words) box.append(element("p", { class: "note" }, section.words));
  }
  const leftOut = data.sections.filter((section) => section.screen_only).map((section) => section.title);
  if (data.sections.some((section) => section.type === "program")) leftOut.push("further curves along the program");
  main.append(...sheetWords(leftOut, element).filter((of) => of), element("p", { class: "soft" }, data.made_by));
  document.documentElement.dataset.built = "yes";
}

build(JSON.parse(document.getElementById("data").textContent), document.getElementById("page"));
