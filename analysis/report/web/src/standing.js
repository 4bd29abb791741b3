import { svg } from './dom.js';

/** Of a picture outside its page: letters that viewers have where system-ui is unknown. */
export const font = 'Arial, "Liberation Sans", Helvetica, sans-serif';

/** What a page's style gives an element of a picture, by the names of attributes. */
const styled = ['fill', 'stroke', 'stroke-width', 'opacity', 'font-size', 'font-weight', 'text-anchor', 'dominant-baseline'];
/** What a picture has without saying so. */
const initial = { stroke: 'none', 'stroke-width': '1px', opacity: '1', 'font-weight': '400', 'text-anchor': 'start', 'dominant-baseline': 'auto' };

/** Where letters begin below a line at their top, middle or bottom, in sizes of the font: few viewers know baselines. */
const drops = { hanging: 0.74, 'text-before-edge': 0.9, central: 0.35, middle: 0.35, 'text-after-edge': -0.22 };

const hex = (share) => Math.round(255 * share).toString(16).padStart(2, '0');

/** A colour as all viewers read it, #rrggbb, and its opacity; null where it is none, as `none` is. */
export function plainColour(text) {
  const [, name, inside] = /^(rgba?|color)\((?:srgb )?(.*)\)$/.exec(text.trim()) ?? [];
  if (!name) return null;
  const [red, green, blue, alpha = '1'] = inside.split(/[\s,/]+/);
  const share = name === 'color' ? 1 : 1 / 255;
  return { colour: `#${[red, green, blue].map((part) => hex(share * Number(part))).join('')}`, opacity: Number(alpha) };
}

function withoutFunctions(element) {
  for (const name of ['fill', 'stroke']) {
    const plain = plainColour(element.getAttribute(name) ?? '');
    if (!plain) continue;
    element.setAttribute(name, plain.colour);
    if (plain.opacity < 1) element.setAttribute(`${name}-opacity`, plain.opacity);
  }
}

function withoutBaseline(element) {
  const drop = drops[element.getAttribute('dominant-baseline')];
  element.removeAttribute('dominant-baseline');
  if (drop) element.setAttribute('y', Number(element.getAttribute('y') ?? 0) + drop * Number.parseFloat(element.getAttribute('font-size')));
}

/** Makes of a picture one that needs no page: plain colours, letters by their place alone, no names for a page's style. */
export function plain(picture) {
  for (const element of [picture, ...picture.querySelectorAll('*')]) {
    withoutFunctions(element);
    if (element.matches('text')) withoutBaseline(element);
    for (const name of ['style', 'class', 'role', 'tabindex', 'pointer-events', 'font-family', 'aria-label']) element.removeAttribute(name);
  }
  return picture;
}

/** A picture of the page with what the page's style gives it, in attributes; without title, as a part of another one. */
export function copied(picture) {
  const copy = picture.cloneNode(true);
  const elements = [...copy.querySelectorAll('*')];
  [...picture.querySelectorAll('*')].forEach((source, i) => {
    const style = getComputedStyle(source);
    for (const name of styled) {
      const value = style.getPropertyValue(name);
      if (value && value !== initial[name]) elements[i].setAttribute(name, name === 'font-size' || name === 'stroke-width' ? Number.parseFloat(value) : value);
    }
  });
  const [, , width, height] = (picture.getAttribute('viewBox') ?? '0 0 600 400').split(' ').map(Number);
  for (const [name, value] of Object.entries({ width, height })) copy.setAttribute(name, value);
  return copy;
}

/** The text of a file that any viewer opens. */
export const textOf = (picture) => new XMLSerializer().serializeToString(picture);

/** An image of the page, itself an SVG, as an element. */
export function ofImage({ src }) {
  const text = decodeURIComponent(src.slice(src.indexOf(',') + 1));
  const picture = new DOMParser().parseFromString(text, 'image/svg+xml').documentElement;
  if (!picture.matches('svg')) throw new Error('this picture is no SVG');
  return svg('svg', {}).ownerDocument.importNode(picture, true);
}
