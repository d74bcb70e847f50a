// SPDX-License-Identifier: MIT
// What the theme's own script leaves out.
const kShort = 24; // characters
const kNumbers = /^[^A-Za-z]*([A-Za-z]{1,3}[^A-Za-z]*)?$/; // with a unit or none

// keys and screen readers
for (const found of document.querySelectorAll('[role="dialog"][data-md-component="search"]')) found.setAttribute('aria-label', 'Search');
// what scrolls within a page can be reached by keys
new MutationObserver(reachable).observe(document.body, { childList: true, subtree: true });
reachable();

function reachable() {
  for (const box of document.querySelectorAll('.md-typeset__scrollwrap, .md-search__scrollwrap, .formula, pre > code')) {
    if (!box.hasAttribute('tabindex')) box.setAttribute('tabindex', '0');
  }
}

// numbers with their quartiles stay in one line, as the table scrolls anyway
for (const cell of document.querySelectorAll('.md-typeset td')) {
  if (cell.textContent.length <= kShort && kNumbers.test(cell.textContent)) cell.style.whiteSpace = 'nowrap';
}
