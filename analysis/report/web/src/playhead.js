/** The moment of a recording that the vehicle shows; no recording: none. */
export const playhead = { recording: null, time: 0 };
const listeners = [];

export function onPlayhead(listener) {
  listeners.push(listener);
}

export function movePlayhead(recording, time) {
  if (playhead.recording == null && recording == null) return;
  Object.assign(playhead, { recording, time });
  for (const listener of listeners) listener();
}

/** A line over a chart of time, of that recording; drawn with the chart, and by `put` when the playhead moves. */
export function playheadLine(recording) {
  return { hooks: { init: [(u) => u.over.append(Object.assign(document.createElement('div'), { className: 'playhead' }))], draw: [(u) => put(u, recording)] } };
}

export function put(u, recording) {
  const line = u.over.querySelector('.playhead');
  const { min, max } = u.scales.x;
  line.hidden = playhead.recording !== recording || !(playhead.time >= min && playhead.time <= max);
  if (!line.hidden) line.style.left = `${u.valToPos(playhead.time, 'x')}px`;
}
