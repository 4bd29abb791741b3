import { unpacked } from '../unpacked.js';

let opened = null;

/** The class Stage of stage.js, which the page holds packed; its policy names that script by its digest. */
export function openStage() {
  return (opened ??= unpack());
}

async function unpack() {
  const text = new TextDecoder().decode(await unpacked(document.getElementById('stage').textContent));
  const script = document.createElement('script');
  script.textContent = text;
  document.head.append(script);
  if (typeof fourpostStage !== 'object') throw new Error('the page does not allow its script');
  return fourpostStage.Stage;
}
