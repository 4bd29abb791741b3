/** Solves A x = b of a few unknowns by elimination with pivots; null where A is singular. */
function solved(a, b) {
  const n = b.length;
  const rows = a.map((row, i) => [...row, b[i]]);
  for (let k = 0; k < n; ++k) {
    const pivot = rows.slice(k).reduce((best, row, i) => (Math.abs(row[k]) > Math.abs(rows[best][k]) ? k + i : best), k);
    if (!(Math.abs(rows[pivot][k]) > 0)) return null;
    [rows[k], rows[pivot]] = [rows[pivot], rows[k]];
    for (let i = 0; i < n; ++i) {
      if (i === k) continue;
      const times = rows[i][k] / rows[k][k];
      for (let j = k; j <= n; ++j) rows[i][j] -= times * rows[k][j];
    }
  }
  return rows.map((row, i) => row[n] / row[i]);
}

/** What changes of a parameter are relative to in the covariance of a result: its value, or its range of either sign. */
const sizeOf = ({ value, lower, upper }) => (lower < 0 && upper > 0 ? upper - lower : value);

/** The covariance of noise of a result for these parameters, relative, as a whole matrix; null where it is not known. */
export function covarianceOf(result, parameters) {
  const { parameters: names, noise } = result.intervals?.covariance ?? {};
  if (!Array.isArray(names) || !Array.isArray(noise)) return null;
  const places = parameters.map(({ name }) => names.indexOf(name));
  if (!places.some((place) => place >= 0)) return null;
  const at = (i, k) => (i < 0 || k < 0 ? 0 : noise[Math.max(i, k)]?.[Math.min(i, k)]);
  const matrix = places.map((i) => places.map((k) => at(i, k)));
  return matrix.every((row) => row.every(Number.isFinite)) ? matrix : null;
}

/**
 * Values that the data ask for when some are held elsewhere than the fit has them, by its Jacobian: the conditional mean
 * fit + C_oh C_hh^-1 (held - fit) of the others, within bounds. `held`: places in `values`.
 */
export function resolved(covariance, parameters, values, held) {
  const known = held.filter((h) => covariance[h][h] > 0);
  const changes = known.map((h) => (values[h] - parameters[h].value) / sizeOf(parameters[h]));
  const weights = solved(known.map((h) => known.map((k) => covariance[h][k])), changes);
  if (!weights) return values;
  return values.map((value, o) => {
    if (held.includes(o) || !(covariance[o][o] > 0)) return value;
    const share = known.reduce((sum, h, i) => sum + covariance[o][h] * weights[i], 0);
    const { lower, upper } = parameters[o];
    return Math.min(upper, Math.max(lower, parameters[o].value + share * sizeOf(parameters[o])));
  });
}
