// What is drawn on a canvas.

/** How many pixels of a canvas have a colour near this one. */
export function coloured(canvas, [red, green, blue]) {
  return canvas.evaluate(
    (element, [r, g, b]) => {
      const { data } = element.getContext('2d').getImageData(0, 0, element.width, element.height);
      let count = 0;
      for (let i = 0; i < data.length; i += 4)
        if (data[i + 3] > 128 && Math.abs(data[i] - r) + Math.abs(data[i + 1] - g) + Math.abs(data[i + 2] - b) < 60) ++count;
      return count;
    },
    [red, green, blue],
  );
}

/** From the uppermost to the lowest of such pixels, right of a share of the canvas. */
export function colouredHeight(canvas, [red, green, blue], from) {
  return canvas.evaluate(
    (element, [r, g, b, left]) => {
      const { width, height } = element;
      const { data } = element.getContext('2d').getImageData(0, 0, width, height);
      const rows = [];
      for (let y = 0; y < height; ++y)
        for (let x = Math.ceil(left * width); x < width; ++x) {
          const i = 4 * (y * width + x);
          if (data[i + 3] > 128 && Math.abs(data[i] - r) + Math.abs(data[i + 1] - g) + Math.abs(data[i + 2] - b) < 60) rows.push(y);
        }
      return rows.length ? rows[rows.length - 1] - rows[0] + 1 : 0;
    },
    [red, green, blue, from],
  );
}

export const measuredColour = [0x00, 0x72, 0xb2];
export const modelColour = [0xd5, 0x5e, 0x00];
