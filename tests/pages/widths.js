// Nothing is wider than the window, or sticks out of it, but what has a place of its own to scroll in: tables of many columns and trees.
const check_widths = check => {
  const wide = document.documentElement.scrollWidth;
  check(wide <= innerWidth, `the page is ${wide} wide, the window ${innerWidth}`);
  const seen = new Set();
  for (const e of document.querySelectorAll('body *')) {
    if (e.closest('svg') != null && e.tagName != 'svg' || e.parentElement.closest('.scroll, .tree')) continue;
    const {left, right, width} = e.getBoundingClientRect(), name = `${e.tagName}.${e.className.baseVal ?? e.className}`;
    if (width == 0 || (left >= -0.5 && right <= innerWidth + 0.5) || seen.has(name)) continue;
    seen.add(name);
    check(false, `${name} reaches from ${left.toFixed(0)} to ${right.toFixed(0)}, the window to ${innerWidth}: ${e.textContent.trim().slice(0, 30)}`);
  }
  // What is cut off, or scrolls, within the window.
  for (const e of document.querySelectorAll('body *'))
    if (!e.closest('svg, select, input, .scroll, .tree') && e.scrollWidth > e.clientWidth + 1 && getComputedStyle(e).overflowX != 'visible')
      check(false, `${e.tagName}.${e.className} has ${e.scrollWidth} within ${e.clientWidth}`);
};
