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

/** At the digits that a slider can tell apart. */
export const rounded = (parameter, value) => Number(value.toPrecision(4));

/** Options of the program for what differs from the fit. */
export function asOptions(parameters, values) {
  return parameters
    .flatMap(({ name, unit, value }, i) => (values[i] === value ? [] : [`--set ${name}=${Number(values[i].toPrecision(6))}${unit && unit !== '1' ? unit : ''}`]))
    .join(' ');
}
