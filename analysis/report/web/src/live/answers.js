/** Who draws what the car of the sliders would do: called with {responses, modes, rests}, or null where it is shut. */
const listeners = [];

export function onAnswer(listener) {
  listeners.push(listener);
}

export function tellAnswer(answer) {
  for (const listener of listeners) listener(answer);
}
