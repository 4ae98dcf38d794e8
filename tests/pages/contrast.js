// Of text to what is behind it: 4.5 by WCAG 2, AA.
const check_contrast = (check, theme) => {
  const parts = c => { const m = c.match(/[\d.]+/g).map(Number); return m.length > 3 ? m : [...m, 1]; };
  const light = c => {
    const [r, g, b] = c.map(x => { x /= 255; return x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4; });
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const ratio = (a, b) => { const [x, y] = [light(a), light(b)].sort((p, q) => q - p); return (x + 0.05) / (y + 0.05); };
  const behind = e => {
    for (; e; e = e.parentElement) {
      const c = parts(getComputedStyle(e).backgroundColor);
      if (c[3] == 1) return c;
    }
    return [255, 255, 255, 1];
  };
  const seen = new Set();
  for (const e of document.querySelectorAll('body *')) {
    if (!e.getClientRects().length || e.disabled) continue;
    if (![...e.childNodes].some(n => n.nodeType == 3 && n.textContent.trim())) continue;
    if (['SCRIPT', 'STYLE', 'title', 'OPTION'].includes(e.tagName)) continue;
    let ink, paper;
    if (e.tagName == 'text') {
      ink = parts(getComputedStyle(e).fill);
      const box = e.parentElement.tagName == 'g' ? e.parentElement.querySelector('rect') : e.closest('.tree') ? e.previousElementSibling : null;
      paper = box && getComputedStyle(box).fill != 'none' ? parts(getComputedStyle(box).fill) : behind(e.closest('svg'));
    } else {
      ink = parts(getComputedStyle(e).color);
      paper = behind(e);
    }
    const r = ratio(ink.slice(0, 3), paper.slice(0, 3)), name = `${theme}: ${e.tagName}.${e.className.baseVal ?? e.className}`;
    if (r < 4.5 && !seen.has(name)) {
      seen.add(name);
      check(false, `contrast ${r.toFixed(2)} of ${name}: ${e.textContent.slice(0, 30)}`);
    }
  }
};
