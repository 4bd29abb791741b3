/** Bytes of base 64. */
export const bytesOf = (base64) => Uint8Array.from(atob(base64), (digit) => digit.charCodeAt(0));

/** The bytes that gzip packed, in base 64. Throws where a browser cannot unpack. */
export async function unpacked(base64) {
  if (typeof DecompressionStream !== 'function') throw new Error('this browser cannot unpack it');
  return new Response(new Blob([bytesOf(base64)]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
}
