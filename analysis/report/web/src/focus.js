// What leads to a curve: a cell of a table, the worst channel of the summary.
const listeners = [];

/** Called with {recording, channel, low, high}: which curve, and between which frequencies [Hz] or not. */
export function onFocus(listener) {
  listeners.push(listener);
}

export function focus(target) {
  for (const listener of listeners) listener(target);
}
