// Axes of a chart: from values to pixels and back, with the values that are labelled.

const PREFIXES = [
  [1e9, "G"],
  [1e6, "M"],
  [1e3, "k"],
  [1, ""],
  [1e-3, "m"],
  [1e-6, "µ"],
  [1e-9, "n"],
];

/** A unit with a prefix in which this value is between 1 and 1000: its factor and its name. */
export function prefixed(value, unit) {
  if (!unit || !value) return { factor: 1, unit };
  const [factor, prefix] = PREFIXES.find(([factor]) => Math.abs(value) >= factor) ?? PREFIXES.at(-1);
  return { factor, unit: prefix + unit };
}

/** A value with four digits and its unit. */
export function quantity(value, unit) {
  const { factor, unit: name } = prefixed(value, unit);
  return `${digits(value / factor)} ${name}`.trim();
}

/** A number with at most four digits, without exponent where it can be read. */
export function digits(number) {
  if (number !== 0 && (Math.abs(number) < 1e-4 || Math.abs(number) >= 1e6)) return number.toExponential(3);
  return String(Number(number.toPrecision(4)));
}

/**
 * The axis from `low` to `high` on the pixels from `start` to `end`: `at(value)`, `value(pixel)`, and `ticks`, no two of them closer
 * than `room` pixels.
 */
export function makeScale({ low, high, isLog }, [start, end], room) {
  const bend = isLog ? Math.log10 : (value) => value;
  const [from, to] = [bend(low), bend(high)];
  const at = (value) => start + ((bend(value) - from) / (to - from || 1)) * (end - start);
  const value = (pixel) => {
    const bent = from + ((pixel - start) / (end - start)) * (to - from);
    return isLog ? 10 ** bent : bent;
  };
  const most = Math.max(2, Math.floor(Math.abs(end - start) / room));
  return { at, value, ticks: isLog ? powers(from, to, most) : steps(low, high, most) };
}

// Powers of ten: all of them, or every second, third …
function powers(from, to, most) {
  const [first, last] = [Math.ceil(from - 1e-9), Math.floor(to + 1e-9)];
  const every = Math.max(1, Math.ceil((last - first + 1) / most));
  const all = Array.from({ length: Math.max(0, last - first + 1) }, (_, at) => first + at);
  return all
    .filter((power) => (power - first) % every === 0)
    .map((power) => ({ value: 10 ** power, text: Math.abs(power) <= 3 ? String(Number(`1e${power}`)) : `1e${power}` }));
}

// Multiples of 1, 2 or 5 of a power of ten.
function steps(low, high, most) {
  const least = (high - low) / most;
  if (!(least > 0)) return [];
  const power = 10 ** Math.floor(Math.log10(least));
  const step = power * [1, 2, 5, 10].find((digit) => digit * power >= least * (1 - 1e-9));
  const first = Math.ceil(low / step - 1e-9);
  const count = Math.floor(high / step + 1e-9) - first + 1;
  return Array.from({ length: count }, (_, at) => {
    const value = (first + at) * step;
    return { value, text: String(Number(value.toPrecision(6))) };
  });
}
