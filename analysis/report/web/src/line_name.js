/** What the line of the car of the page is called: of a page that shows no fit it is no fit. */
export let fit = 'fit';

export const nameFit = (name) => (fit = name);
