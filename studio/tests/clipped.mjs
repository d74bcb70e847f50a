// SPDX-License-Identifier: MIT

/** Text of a page that is seen and cut off by its own box, or lies over other text, as lines; what scrolls or ends in an ellipsis by design is not. */
export function clippedText(page) {
  return page.evaluate(() => {
    const kSlack = 1.5; // px: letters reach a little out of their boxes
    const kLeast = 3; // px that are seen of a line
    const findings = [];
    const texts = [];
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
      const text = node.textContent.trim();
      const element = node.parentElement;
      if (text === '' || !element.checkVisibility({ opacityProperty: true, visibilityProperty: true }) || element.closest('option, script, style, canvas, svg')) continue;
      let scrolls = false;
      let clip = { left: 0, top: 0, right: innerWidth, bottom: innerHeight };
      for (let around = element; around; around = around.parentElement) {
        const { overflowX, overflowY, textOverflow } = getComputedStyle(around);
        if (overflowX === 'visible' && overflowY === 'visible') continue;
        if (textOverflow === 'ellipsis' || [overflowX, overflowY].some((way) => way === 'auto' || way === 'scroll')) scrolls = true;
        const edge = around.getBoundingClientRect();
        clip = { left: Math.max(clip.left, edge.left), top: Math.max(clip.top, edge.top), right: Math.min(clip.right, edge.right), bottom: Math.min(clip.bottom, edge.bottom) };
      }
      const range = document.createRange();
      range.selectNodeContents(node);
      for (const line of range.getClientRects()) {
        const seen = { left: Math.max(line.left, clip.left), top: Math.max(line.top, clip.top), right: Math.min(line.right, clip.right), bottom: Math.min(line.bottom, clip.bottom) };
        if (seen.right - seen.left < kLeast || seen.bottom - seen.top < kLeast) continue;
        const top = document.elementFromPoint((seen.left + seen.right) / 2, (seen.top + seen.bottom) / 2);
        if (!top || !element.contains(top)) continue; // something lies over it
        const cut = Math.max(seen.left - line.left, line.right - seen.right, seen.top - line.top, line.bottom - seen.bottom);
        if (cut > kSlack && !scrolls) findings.push(`cut off by ${cut.toFixed(0)} px: ${text.slice(0, 40)}`);
        texts.push({ text, node, layer: element.closest(':popover-open, dialog'), ...seen });
      }
    }
    for (let i = 0; i < texts.length; ++i) {
      for (let j = i + 1; j < texts.length; ++j) {
        const [a, b] = [texts[i], texts[j]];
        if (a.node === b.node || a.layer !== b.layer) continue; // a menu may cover a part of what lies below
        const over = Math.min(a.right - b.left, b.right - a.left, a.bottom - b.top, b.bottom - a.top);
        if (over > 2 * kSlack) findings.push(`“${a.text.slice(0, 30)}” and “${b.text.slice(0, 30)}” overlap by ${over.toFixed(0)} px`);
      }
    }
    return findings;
  });
}
