// Columns of numbers as a page carries them: whole multiples of a quantum, four bytes each, little end first, in base64.

const kMissing = -2147483648;

/// A Float64Array of {quantum, data}; NaN where a number is missing.
export function decoded(column) {
  const bytes = atob(column.data);
  const count = bytes.length / 4;
  const values = new Float64Array(count);
  // The product with a power of ten is rounded once, so that 0.1 stays 0.1.
  const per = Math.round(1 / column.quantum);
  for (let i = 0; i < count; ++i) {
    const at = 4 * i;
    const whole = bytes.charCodeAt(at) | (bytes.charCodeAt(at + 1) << 8) | (bytes.charCodeAt(at + 2) << 16) |
      (bytes.charCodeAt(at + 3) << 24);
    values[i] = whole === kMissing ? NaN : per > 1 ? whole / per : whole * column.quantum;
  }
  return values;
}

/// [least, largest] of the numbers that there are; [0, 1] where there is none.
export function extent(...columns) {
  let least = Infinity;
  let largest = -Infinity;
  for (const values of columns) {
    for (const value of values) {
      if (value < least) least = value;
      if (value > largest) largest = value;
    }
  }
  return least <= largest ? [least, largest] : [0, 1];
}

/// The place of the value of a rising column that is nearest to `at`.
export function nearest(rising, at) {
  let low = 0;
  let high = rising.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (rising[middle] <= at) low = middle;
    else high = middle;
  }
  return Math.abs(rising[low] - at) <= Math.abs(rising[high] - at) ? low : high;
}

/// Places of `values`[from, to) that draw the same picture in `buckets` columns of pixels: the first, the least and the
/// largest of each, in order.
export function thinned(values, from, to, buckets) {
  const kept = [];
  const width = (to - from) / buckets;
  if (width <= 3) {
    for (let i = from; i < to; ++i) kept.push(i);
    return kept;
  }
  for (let bucket = 0; bucket < buckets; ++bucket) {
    const begin = from + Math.floor(bucket * width);
    const end = bucket + 1 === buckets ? to : from + Math.floor((bucket + 1) * width);
    let least = begin;
    let largest = begin;
    for (let i = begin + 1; i < end; ++i) {
      if (values[i] < values[least]) least = i;
      if (values[i] > values[largest]) largest = i;
    }
    kept.push(...[...new Set([begin, least, largest, end - 1])].sort((a, b) => a - b));
  }
  return kept;
}
