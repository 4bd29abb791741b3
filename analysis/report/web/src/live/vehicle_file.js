const escaped = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' };
const written = (text) => text.replaceAll(/[&<>"]/g, (sign) => escaped[sign]);

/** A vehicle file with other values of its parameters: {name, unit, value}; all else stays as it is written. */
export function withValues(file, parameters) {
  const known = new Map(parameters.map(({ name, unit, value }) => [written(name), `${value}${unit && unit !== '1' ? ` ${unit}` : ''}`]));
  return file.replaceAll(/<(?:[\w.-]+:)?parameter\b[^>]*>/g, (tag) => {
    const name = /\sname=(["'])(.*?)\1/.exec(tag)?.[2];
    return known.has(name) ? tag.replace(/(\svalue=)(["']).*?\2/, (all, key, quote) => `${key}${quote}${written(known.get(name))}${quote}`) : tag;
  });
}
