// A value as it is written in a scenario: a number with its unit.

/** The number and the unit of a value as it is written; `null` for a word, or for a scale that is not proportional. */
export function parts(value) {
  const [, number, unit] = value?.match(/^([+\d.][\d._]*(?:e[-+]?\d+)?)\s*(\D.*)?$/i) ?? [];
  const known = Number(number?.replaceAll("_", ""));
  return known > 0 && !/^HR/.test(unit ?? "") ? { number: known, unit: unit?.trim() ?? "" } : null;
}

/** A number with three digits, as it is written into a scenario. */
export const written = (number) => String(Number(number.toPrecision(3)));

/** A positive number that is one larger or smaller in its second digit. */
export function stepped(number, by) {
  const power = 10 ** (Math.floor(Math.log10(number)) - 1);
  // from 10 downwards the second digit is that of 9.9
  const step = by < 0 && Math.round(number / power) <= 10 ? power / 10 : power;
  return written((Math.round(number / step) + by) * step);
}
