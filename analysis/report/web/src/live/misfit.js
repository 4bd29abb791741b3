/** Gain and phase [deg] of a channel of an answer; nulls where it has none. */
export function polar({ re, im }) {
  const numbers = (of) => Array.from(re, (x, i) => (Number.isFinite(x) ? of(x, im[i]) : null));
  return { gain: numbers(Math.hypot), phase: numbers((x, y) => (Math.atan2(y, x) * 180) / Math.PI) };
}

/** Largest measured gain of each unit at each frequency. */
export function loudestOf(channels) {
  const loudest = new Map();
  for (const { unit, gain_measured } of channels) {
    const most = loudest.get(unit) ?? gain_measured.map(() => 0);
    loudest.set(unit, most.map((value, i) => Math.max(value, gain_measured[i] ?? 0)));
  }
  return loudest;
}

const radian = Math.PI / 180;
/** Null where nothing weighs it. */
const over = (difference, sd) => (sd > 0 && Number.isFinite(difference) ? difference / sd : null);

/**
 * Residuals of a channel in standard deviations, as FourPostResiduals() weighs them: along and across the measured
 * phasor, and of the mean. `answer`: {gain, phase, mean}; `loudest`: of the channel's unit. Null where there is none.
 */
export function residualsOf(channel, answer, error, loudest) {
  const share = 10 ** (error.gain_dB / 20) - 1;
  const has = (i) => channel.gain_measured[i] != null && answer.gain[i] != null;
  const of = (number) => channel.gain_measured.map((_, i) => (has(i) ? number(i) : null));
  const turn = (i) => ((answer.phase[i] ?? NaN) - (channel.phase_measured?.[i] ?? NaN)) * radian;
  const floor = (i) => error.floor * loudest[i];
  return {
    along: of((i) => {
      const gain = channel.gain_measured[i];
      return over(answer.gain[i] * Math.cos(turn(i)) - gain, Math.hypot(channel.gain_sd?.[i] ?? 0, gain * share, floor(i)));
    }),
    across: of((i) => {
      const gain = channel.gain_measured[i];
      return over(answer.gain[i] * Math.sin(turn(i)), Math.hypot((channel.phase_sd?.[i] ?? 0) * radian * gain, gain * error.phase_rad, floor(i)));
    }),
    mean: channel.gain_measured.map((_, i) =>
      channel.mean_measured?.[i] != null && answer.mean?.[i] != null ? over(answer.mean[i] - channel.mean_measured[i], error.mean_m) : null,
    ),
  };
}

/**
 * Sum of squared residuals of a recording's channels and their number. `answers`: {gain, phase, mean} of each channel.
 * Rows out of band are none, nor are those without an answer.
 */
export function squaresOf(channels, answers, error) {
  const loudest = loudestOf(channels);
  let sum = 0;
  let count = 0;
  channels.forEach((channel, c) => {
    const residuals = residualsOf(channel, answers[c], error, loudest.get(channel.unit));
    for (const list of Object.values(residuals))
      list.forEach((residual, i) => {
        if (!channel.in_band[i] || residual == null) return;
        sum += residual * residual;
        count += 1;
      });
  });
  return { sum, count };
}

/**
 * Misfit of the whole fit where responses have other squares than those of the fit; all else stays as fitted. `expected`:
 * the sum of squares of which noise and stated model error make a misfit of 1.
 */
export const movedMisfit = (whole, fitted, now, expected) => Math.sqrt(Math.max(0, whole * whole + (now.sum - fitted.sum) / expected));

/** Root mean square of residuals, with the degrees of freedom that a fit of so many parameters, or none, takes of all residuals. */
export function misfitOf(parts, parameters, residuals) {
  const sum = parts.reduce((all, part) => all + part.sum, 0);
  const count = parts.reduce((all, part) => all + part.count, 0);
  return count ? Math.sqrt(sum / (count * Math.max(1 - (parameters ? parameters / residuals : 0), 0.01))) : null;
}
