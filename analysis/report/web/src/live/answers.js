/** Who draws what the car of the sliders would do: called with {responses, modes, rests}, or null where it is shut. */
const listeners = [];
let last = null;

/** Called at once where there is an answer already. */
export function onAnswer(listener) {
  listeners.push(listener);
  if (last) listener(last);
}

export function tellAnswer(answer) {
  last = answer;
  for (const listener of listeners) listener(answer);
}
