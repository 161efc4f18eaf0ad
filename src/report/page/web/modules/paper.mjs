// Print: pictures are drawn anew for the width of a sheet, so that their text keeps its size.

const kSheetPx = 688;  // A4 less its margins (style.css), 96 pixels an inch

/// `redraw(scale)` draws for `scale` times the width that there is: before a print as wide as on the sheet, after it as
/// before.
export function redrawForPrint(redraw) {
  window.addEventListener("beforeprint", () => redraw(kSheetPx / document.getElementById("page").clientWidth));
  window.addEventListener("afterprint", () => redraw(1));
}

/// What a sheet says that a screen need not: when it was printed, and which sections it leaves out.
export function sheetWords(leftOut, element) {
  const when = element("p", { class: "note paper-only" });
  window.addEventListener("beforeprint", () => { when.textContent = `Printed ${new Date().toISOString().slice(0, 16).replace("T", " ")} UTC.`; });
  return [leftOut.length > 0 ? element("p", { class: "note paper-only" }, `On the screen only: ${leftOut.join("; ")}.`) : null, when];
}
