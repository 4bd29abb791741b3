const superscripts = '\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079';

/** At so many significant digits, with a minus sign. */
export function shown(value, digits = 3) {
  if (value == null || !Number.isFinite(value)) return '\u2013';
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-4 || size >= 1e7)) return power(value, digits);
  return apart(size >= 10 ** (digits - 1) ? value.toFixed(0) : Number(value.toPrecision(digits)).toString());
}

/** At so many decimals. */
export function fixed(value, decimals) {
  if (value == null || !Number.isFinite(value)) return '\u2013';
  const text = value.toFixed(decimals);
  return apart(Number(text) === 0 ? text.replace('-', '') : text);
}

function minus(text) {
  return text.replace('-', '\u2212');
}

/** Thousands of five digits and more before the point. */
function apart(text) {
  const [whole, ...rest] = text.split('.');
  const digits = whole.replace('-', '').length > 4 ? whole.replace(/(?<=\d)(?=(\d{3})+$)/g, '\u2009') : whole;
  return minus([digits, ...rest].join('.'));
}

function power(value, digits) {
  const [mantissa, exponent] = value.toExponential(digits - 1).split('e');
  const raised = [...exponent].map((c) => (c === '-' ? '\u207b' : c === '+' ? '' : superscripts[+c]));
  return `${minus(mantissa)}\u00b710${raised.join('')}`;
}

export const decibel = (gain) => (gain > 0 ? 20 * Math.log10(gain) : null);

/** A list of a result; nothing where it is none, as in a result of another version. */
export const listOf = (value) => (Array.isArray(value) ? value : []);

/** Least and greatest of numbers that may be null; nothing when there is none. */
export function extent(...lists) {
  let least = Infinity;
  let greatest = -Infinity;
  for (const list of lists)
    for (const value of list)
      if (value != null && Number.isFinite(value)) {
        if (value < least) least = value;
        if (value > greatest) greatest = value;
      }
  return least <= greatest ? [least, greatest] : null;
}

/** A step of 1, 2 or 5 times a power of ten that parts a range into about so many. */
export function niceStep(range, count) {
  const rough = range / count;
  const unit = 10 ** Math.floor(Math.log10(rough));
  return unit * [1, 2, 5, 10].find((factor) => factor * unit >= rough * 0.999);
}

/** Multiples of a step within a range. */
export function multiples(low, high, step) {
  const list = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) list.push(i * step);
  return list;
}

/** 0.5, 1, 2, 5, 10 ... within a range. */
export function decades(low, high) {
  const list = [];
  for (let exponent = Math.floor(Math.log10(low)); exponent <= Math.ceil(Math.log10(high)); ++exponent)
    for (const factor of [1, 2, 5]) {
      const value = factor * 10 ** exponent;
      if (value >= low * 0.999 && value <= high * 1.001) list.push(value);
    }
  return list;
}

/** Marks of a logarithmic axis: powers of ten, 2 and 5 times them where they are few, even steps where those are. */
export function logTicks(low, high) {
  const all = decades(low, high);
  const tens = all.filter((value) => Math.abs(Math.log10(value) - Math.round(Math.log10(value))) < 1e-9);
  if (high / low > 1e4 && tens.length > 3) return tens;
  return all.length > 2 ? all : multiples(low, high, niceStep(high - low, 5));
}

/** Decimals that tell numbers this far apart. */
export const decimalsOf = (gap) => Math.max(0, -Math.floor(Math.log10(gap) + 1e-9));
