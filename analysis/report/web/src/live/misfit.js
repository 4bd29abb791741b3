/** Gain and phase [deg] of a channel of an answer; nulls where it has none. */
export function polar({ re, im }) {
  const numbers = (of) => Array.from(re, (x, i) => (Number.isFinite(x) ? of(x, im[i]) : null));
  return { gain: numbers(Math.hypot), phase: numbers((x, y) => (Math.atan2(y, x) * 180) / Math.PI) };
}

/** Largest measured gain of each unit at each frequency. */
function loudestOf(channels) {
  const loudest = new Map();
  for (const { unit, gain_measured } of channels) {
    const most = loudest.get(unit) ?? gain_measured.map(() => 0);
    loudest.set(unit, most.map((value, i) => Math.max(value, gain_measured[i] ?? 0)));
  }
  return loudest;
}

/**
 * Sum of squared residuals of a recording's channels and their number, as FourPostResiduals() weighs them: along and
 * across the measured phasor, and of means. `answers`: {gain, phase, mean} of each channel. Rows out of band are none,
 * nor are those without an answer.
 */
export function squaresOf(channels, answers, error) {
  const loudest = loudestOf(channels);
  const share = 10 ** (error.gain_dB / 20) - 1;
  const radian = Math.PI / 180;
  let sum = 0;
  let count = 0;
  const add = (residual) => {
    sum += residual * residual;
    count += 1;
  };
  channels.forEach((channel, c) => {
    const answer = answers[c];
    channel.gain_measured.forEach((gain, i) => {
      if (!channel.in_band[i] || gain == null) return;
      if (answer.gain[i] != null) {
        const turn = (answer.phase[i] - channel.phase_measured[i]) * radian;
        const floor = error.floor * loudest.get(channel.unit)[i];
        add((answer.gain[i] * Math.cos(turn) - gain) / Math.hypot(channel.gain_sd?.[i] ?? 0, gain * share, floor));
        add((answer.gain[i] * Math.sin(turn)) / Math.hypot((channel.phase_sd?.[i] ?? 0) * radian * gain, gain * error.phase_rad, floor));
      }
      if (channel.mean_measured?.[i] != null && answer.mean?.[i] != null) add((answer.mean[i] - channel.mean_measured[i]) / error.mean_m);
    });
  });
  return { sum, count };
}

/** Root mean square of residuals, with the degrees of freedom that a fit of so many parameters takes of all residuals. */
export function misfitOf(parts, parameters, residuals) {
  const sum = parts.reduce((all, part) => all + part.sum, 0);
  const count = parts.reduce((all, part) => all + part.count, 0);
  return count ? Math.sqrt(sum / (count * Math.max(1 - parameters / residuals, 0.01))) : null;
}
