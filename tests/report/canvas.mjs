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

export const measuredColour = [0x00, 0x72, 0xb2];
export const modelColour = [0xd5, 0x5e, 0x00];
