/** An element with properties and children; strings become text, never HTML. */
export function el(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  assign(element, properties);
  element.append(...children.flat().filter((child) => child != null));
  return element;
}

/** The same in SVG. */
export function svg(tag, attributes = {}, ...children) {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children.filter((child) => child != null));
  return element;
}

function assign(element, properties) {
  for (const [name, value] of Object.entries(properties)) {
    if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
    else if (name === 'style') Object.assign(element.style, value);
    else if (name in element && name !== 'list') element[name] = value;
    else element.setAttribute(name, value);
  }
}

/** Buttons of which one is pressed. `options`: [value, label]. */
export function choice(label, options, chosen, change) {
  const buttons = options.map(([value, text]) =>
    el('button', { type: 'button', onclick: () => select(value) }, text),
  );
  function select(value) {
    buttons.forEach((button, i) => button.setAttribute('aria-pressed', options[i][0] === value));
    change(value);
  }
  buttons.forEach((button, i) => button.setAttribute('aria-pressed', options[i][0] === chosen));
  return Object.assign(el('span', { class: 'group', role: 'group', 'aria-label': label }, ...buttons), { select });
}

/** A box to tick with its label. */
export function tick(label, checked, change) {
  const input = el('input', { type: 'checkbox', checked, onchange: () => change(input.checked) });
  return el('label', {}, input, label);
}
