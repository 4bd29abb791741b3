// What the reader chose stands in the page's address behind the section: #responses&recording=pitch&axes=all. So a
// link leads another reader to the same view.

// Without a page, as in tests, there is none.
const [section, ...pairs] = (globalThis.location?.hash ?? '').slice(1).split('&');
const values = new Map(pairs.map((pair) => pair.split('=').map(decodeURIComponent)).filter(([key, value]) => key && value != null));
let here = section;

/** Nothing where the reader chose nothing. */
export const inAddress = (key) => values.get(key) ?? null;

function write() {
  const chosen = [...values].map(([key, value]) => `&${encodeURIComponent(key)}=${encodeURIComponent(value)}`).join('');
  const wanted = here || chosen ? `#${here}${chosen}` : location.pathname + location.search;
  if (wanted !== location.hash) history.replaceState(null, '', wanted);
}

/** Null takes it from the address. */
export function putInAddress(key, value) {
  if (value == null || value === '') values.delete(key);
  else values.set(key, String(value));
  write();
}

/** A link to a section leaves what was chosen; an address that was opened leads to its section. */
export function keepAddress() {
  addEventListener('hashchange', () => {
    here = location.hash.slice(1).split('&')[0];
    write();
  });
  if (pairs.length && section) document.getElementById(section)?.scrollIntoView();
}
