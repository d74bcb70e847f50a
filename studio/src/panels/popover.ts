// SPDX-License-Identifier: MIT
// Where a menu that a button opens stands.

const kGap = 6; // px between the button and the menu, and between the menu and the page's edges

/** Puts a menu beside its button whenever it opens or the page's size changes, always inside the page. Returns a function that ends this. */
export function keepPlaced(menu: HTMLElement, opener: HTMLElement, side: 'above' | 'below'): () => void {
  const place = (): void => {
    if (!menu.matches(':popover-open')) return;
    const from = opener.getBoundingClientRect();
    menu.style.maxHeight = `${window.innerHeight - 2 * kGap}px`;
    const { offsetWidth: width, offsetHeight: height } = menu;
    const inside = (value: number, most: number): number => Math.max(Math.min(value, most - kGap), kGap);
    menu.style.left = `${inside(from.right - width, window.innerWidth - width)}px`;
    const top = side === 'above' ? from.top - kGap - height : from.bottom + kGap;
    menu.style.top = `${inside(top, window.innerHeight - height)}px`;
  };
  menu.addEventListener('toggle', place);
  // Escape closes the menu alone
  menu.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') event.stopPropagation();
  });
  window.addEventListener('resize', place);
  return () => window.removeEventListener('resize', place);
}
