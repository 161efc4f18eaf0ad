// Colours that readers with any colour vision can tell apart.

/// A ramp over [from, to] for lines on the page's ground: viridis without the end that is as light, or as dark, as the
/// ground is. What is no number is grey.
export function lineRamp(from, to) {
  const dark = window.matchMedia("(prefers-color-scheme: dark)").matches;
  const [low, high] = dark ? [0.3, 1] : [0, 0.82];
  const span = to > from ? to - from : 1;
  const share = (value) => Math.max(0, Math.min(1, (value - from) / span));
  return (value) => (Number.isFinite(value) ? d3.interpolateViridis(low + (high - low) * share(value)) : "#8a8f96");
}

/// The colour of that style, as the page has it, dark or light.
export function colourOfSeries(index) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--series-${seriesOf(index)}`).trim();
}

/// The number of a style of series (1 to 6), for the classes stroke-1, dash-1 ...
export function seriesOf(index) {
  return (index % 6) + 1;
}
