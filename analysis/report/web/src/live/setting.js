/** Where a value stands on its slider, 0 to 1; bounds of one sign more than a factor of 50 apart make it logarithmic. */
export const isLogarithmic = ({ lower, upper }) => lower > 0 && upper > 50 * lower;

export function shareOf(parameter, value) {
  const { lower, upper } = parameter;
  if (!(upper > lower)) return 0.5;
  const share = isLogarithmic(parameter) ? Math.log(value / lower) / Math.log(upper / lower) : (value - lower) / (upper - lower);
  return Math.min(1, Math.max(0, share));
}

export function valueAt(parameter, share) {
  const { lower, upper } = parameter;
  return isLogarithmic(parameter) ? lower * (upper / lower) ** share : lower + share * (upper - lower);
}

/** Values in the parameters' units as the vehicle takes them: SI, in its order. */
export function inSi(parameters, values) {
  const si = new Float64Array(parameters.length);
  parameters.forEach((parameter, i) => (si[parameter.index] = values[i] * parameter.si));
  return si;
}

const numberIn = (text) => (/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(text) ? Number(text) : null);

/**
 * What a reader typed for a parameter: {value, said}, `said` where it is not what was typed; without a value it is refused.
 * A number, also with its unit, or a change relative to the fit: "-30 %", "*0.7", "/2".
 */
export function typedValue(parameter, text) {
  const { name, unit, lower, upper, value: fit } = parameter;
  const plain = text.replaceAll(/\s/g, '').replaceAll('\u2212', '-').replaceAll('\u00d7', '*').replace(',', '.');
  const ofUnit = unit.replaceAll(/\s/g, '');
  const bare = ofUnit !== '1' && plain.endsWith(ofUnit) ? plain.slice(0, -ofUnit.length) : plain;
  const of = (number, unitOf = ` ${unit}`) => `${Number(number.toPrecision(4))}${unit === '1' ? '' : unitOf}`;
  const [, sign, number, percent] = /^([*/]?)(.*?)(%?)$/.exec(bare);
  const given = numberIn(number);
  const isChange = percent && /^[+-]/.test(number);
  if (given == null || (sign && percent) || (percent && !isChange) || (sign === '/' && given === 0))
    return { said: `${name}: '${text.trim()}' is not understood; write a number, or a change of the fit as -30 % or *0.7.` };
  // A change whose per cent was forgotten.
  if (number.startsWith('+') && !percent) return { said: `${name}: write '${number} %' for a change of the fit, or ${number.slice(1)} for this value.` };
  const value = isChange ? fit * (1 + given / 100) : sign === '*' ? fit * given : sign === '/' ? fit / given : given;
  if (lower > 0 && value <= 0) return { said: `${name} must be positive; ${of(value)} was not taken.` };
  if (value < lower) return { value: lower, said: `${name}: ${of(value, '')} is below its lower bound; set to ${of(lower)}.` };
  if (value > upper) return { value: upper, said: `${name}: ${of(value, '')} is above its upper bound; set to ${of(upper)}.` };
  return { value };
}

/** At the digits that a slider can tell apart. */
export const rounded = (parameter, value) => Number(value.toPrecision(4));

/** Options of the program for what differs from the fit: 3/m where a unit is 1/m. */
export function asOptions(parameters, values) {
  return parameters
    .flatMap(({ name, unit, value }, i) => (values[i] === value ? [] : [`--set ${name}=${Number(values[i].toPrecision(6))}${(unit ?? '').replace(/^1/, '')}`]))
    .join(' ');
}
