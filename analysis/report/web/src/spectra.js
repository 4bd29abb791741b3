/** Fast Fourier transform in place of 2^k complex numbers; `re`, `im`: Float64Array. */
export function fft(re, im) {
  const n = re.length;
  for (let i = 1, j = 0; i < n; ++i) {
    let bit = n >> 1;
    for (; j & bit; bit >>= 1) j ^= bit;
    j ^= bit;
    if (i < j) {
      [re[i], re[j]] = [re[j], re[i]];
      [im[i], im[j]] = [im[j], im[i]];
    }
  }
  for (let size = 2; size <= n; size *= 2) {
    const [c, s] = [Math.cos((2 * Math.PI) / size), -Math.sin((2 * Math.PI) / size)];
    for (let from = 0; from < n; from += size) {
      let [x, y] = [1, 0];
      for (let k = from; k < from + size / 2; ++k) {
        const l = k + size / 2;
        const [a, b] = [re[l] * x - im[l] * y, re[l] * y + im[l] * x];
        [re[l], im[l]] = [re[k] - a, im[k] - b];
        re[k] += a;
        im[k] += b;
        [x, y] = [x * c - y * s, x * s + y * c];
      }
    }
  }
}

/**
 * Power spectra of two signals and their coherence |Sab|^2 / (Saa Sbb), by Welch: Hann windows that overlap by half, each
 * without its mean. Of eight windows or more where there are as many samples; densities in unit^2/Hz.
 */
export function spectraOf(a, b, rate_Hz) {
  const size = 2 ** Math.floor(Math.log2(Math.max(64, Math.min(8192, (2 * a.length) / 9))));
  if (a.length < size) return null;
  const half = size / 2;
  const window = Float64Array.from({ length: size }, (_, i) => 0.5 - 0.5 * Math.cos((2 * Math.PI * i) / size));
  const power = window.reduce((sum, w) => sum + w * w, 0);
  const [aa, bb, re, im] = [0, 0, 0, 0].map(() => new Float64Array(half + 1));
  let count = 0;
  for (let from = 0; from + size <= a.length; from += half) {
    // One transform of both: a real, b imaginary.
    const [x, y] = [a, b].map((list) => {
      const part = Float64Array.from({ length: size }, (_, i) => list[from + i] ?? 0);
      const mean = part.reduce((sum, value) => sum + value, 0) / size;
      return part.map((value, i) => (value - mean) * window[i]);
    });
    fft(x, y);
    for (let k = 0; k <= half; ++k) {
      const l = (size - k) % size;
      const [ar, ai, br, bi] = [(x[k] + x[l]) / 2, (y[k] - y[l]) / 2, (y[k] + y[l]) / 2, (x[l] - x[k]) / 2];
      aa[k] += ar * ar + ai * ai;
      bb[k] += br * br + bi * bi;
      re[k] += ar * br + ai * bi;
      im[k] += ai * br - ar * bi;
    }
    count += 1;
  }
  const scale = 2 / (rate_Hz * power * count);
  const frequency = Float64Array.from({ length: half }, (_, k) => ((k + 1) * rate_Hz) / size);
  const of = (value) => Float64Array.from({ length: half }, (_, k) => value(k + 1));
  return { frequency, first: of((k) => scale * aa[k]), second: of((k) => scale * bb[k]), coherence: of((k) => (aa[k] && bb[k] ? (re[k] ** 2 + im[k] ** 2) / (aa[k] * bb[k]) : 0)), windows: count };
}
