const other = { FL: 'FR', FR: 'FL', RL: 'RR', RR: 'RL', L: 'R', R: 'L', left: 'right', right: 'left' };

/** The same channel on the other side of the car, "a_body_FR" of "a_body_FL"; null of one that names no side. */
export function partnerOf(name) {
  const words = name.split('_');
  const at = words.findLastIndex((word) => other[word]);
  return at < 0 ? null : words.map((word, i) => (i === at ? other[word] : word)).join('_');
}

/** Channels with left and right of a pair one after the other, those without a partner last; null where there are no pairs. */
export function inPairs(channels) {
  const named = new Map(channels.map((channel) => [channel.name, channel]));
  const pairs = channels.filter(({ name }) => named.has(partnerOf(name)));
  if (!pairs.length) return null;
  const ordered = new Set(pairs.flatMap((channel) => [channel, named.get(partnerOf(channel.name))]));
  return [...ordered, ...channels.filter((channel) => !ordered.has(channel))];
}
