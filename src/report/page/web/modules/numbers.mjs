// Numbers as they are read: with their unit, and no more digits than they hold.

const kMinus = "\u2212";

/// `value` with `digits` after the point; "none" for what is not known.
export function numberText(value, digits = 3) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "none";
  const text = Math.abs(value).toFixed(digits);
  return value < 0 && Number(text) !== 0 ? kMinus + text : text;
}

/// The same with its unit.
export function figure(value, unit = "", digits = 3) {
  const text = numberText(value, digits);
  return text === "none" || unit === "" ? text : `${text} ${unit}`;
}

/// 1234567 -> "1,234,567", as the program's other texts have it.
export function countText(count) {
  return String(count).replace(/\B(?=(\d{3})+(?!\d))/g, ",");
}

/// Seconds as a machinist reads a cycle time: "0.412 s", "3 min 07.2 s", "2 h 05 min 00 s".
export function timeText(seconds) {
  if (!Number.isFinite(seconds)) return "none";
  if (seconds < 60) return `${seconds.toFixed(3)} s`;
  const tenths = Math.round(seconds * 10);
  const hours = Math.floor(tenths / 36000);
  const minutes = Math.floor(tenths / 600) % 60;
  const rest = (tenths % 600) / 10;
  const pad = (text) => text.padStart(2, "0");
  if (hours > 0) return `${hours} h ${pad(String(minutes))} min ${pad(rest.toFixed(0))} s`;
  return `${minutes} min ${(rest < 10 ? "0" : "") + rest.toFixed(1)} s`;
}
