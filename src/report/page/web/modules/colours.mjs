// Colours that readers with any colour vision can tell apart.

/// A ramp over [from, to], dark to light (cividis); what is no number is grey.
export function ramp(from, to) {
  const span = to > from ? to - from : 1;
  const clamp = (share) => Math.max(0, Math.min(1, share));
  return (value) => (Number.isFinite(value) ? d3.interpolateCividis(0.08 + 0.92 * clamp((value - from) / span)) : "#8a8f96");
}

/// The number of a style of series (1 to 6), for the classes stroke-1, dash-1 ...
export function seriesOf(index) {
  return (index % 6) + 1;
}
