// What a state has beside its picture, as SVG: intervals along an edge, masks of samples, a tree of planes.
class Diagrams {
  constructor(faces) { this.faces = faces; }
  colour(face) { return face >= 0 ? this.faces[face].colour : 'var(--panel)'; }

  bars(state) {
    let html = '', rows = '', y = 0;
    const row = (name, from, to, fill, face) => {
      const a = 20 + 260 * Math.max(0, Math.min(1, from)), b = 20 + 260 * Math.max(0, Math.min(1, to));
      rows += `<rect x="${a}" y="${y + 2}" width="${Math.max(b - a, 0.8)}" height="9" fill="${fill}"><title>${escaped(name)} ${number_text(from)} … ${number_text(to)}</title></rect>`;
      if (face >= 0) rows += `<text x="${b + 2}" y="${y + 10}" font-size="9">${escaped(this.faces[face].name)}</text>`;
    };
    for (const [name, bars] of state.bars) {
      rows += `<text x="20" y="${y + 9}" font-size="9">${escaped(name)}</text>`;
      y += 12;
      for (const [from, to, face] of bars) {
        row(name, from, to, face >= 0 ? this.colour(face) : name == 'union' || name.endsWith('in front') ? 'var(--quiet)' : 'var(--ink)', face);
        if (name == 'shadows') y += 12;
      }
      if (name != 'shadows' || !bars.length) y += 12;
    }
    html += `<svg class="bars" viewBox="0 0 300 ${y + 14}" role="img" aria-label="Intervals along the edge">${rows}` +
        `<line x1="20" x2="280" y1="${y}" y2="${y}" stroke="var(--ink)"/><text x="17" y="${y + 11}" font-size="9">0</text><text x="277" y="${y + 11}" font-size="9">1</text></svg>`;
    return html;
  }

  // Samples of a pixel, one grid for each fragment.
  masks(name, masks) {
    return `<h4>${escaped(name)}</h4><div class="masks">` + masks.map(([text, face, rows]) => {
      const fill = face >= 0 ? this.colour(face) : 'var(--quiet)';
      let cells = '';
      rows.forEach((row, j) => [...row].forEach((bit, i) => {
        cells += `<rect x="${i}" y="${j}" width="1" height="1" fill="${bit == '1' ? fill : 'none'}" stroke="var(--quiet)" stroke-width="0.06"/>`;
      }));
      const w = rows[0].length, h = rows.length;
      return `<figure><svg viewBox="-0.1 -0.1 ${w + 0.2} ${h + 0.2}" role="img" aria-label="${escaped(text)}: ${rows.join(' ')}">${cells}</svg><figcaption>${escaped(text)}</figcaption></figure>`;
    }).join('') + '</div>';
  }

  // Left: behind; right: in front.
  tree(state, step) {
    const nodes = state.nodes, children = new Map(), place = new Map();
    let root = null;
    for (const n of nodes.values()) {
      if (n.parent < 0) { root = n; continue; }
      const of = children.get(n.parent) || {};
      of[n.side] = n;
      children.set(n.parent, of);
    }
    const waiting = [[root, 0, false]];
    let x = 0, deepest = 0;
    while (waiting.length) {  // in order: what is behind, the node, what is in front
      const [n, depth, is_open] = waiting.pop();
      if (!n) continue;
      deepest = Math.max(deepest, depth);
      if (is_open) { place.set(n.node, [24 + 44 * x++, 20 + 40 * depth]); continue; }
      const of = children.get(n.node) || {};
      waiting.push([of['in front'], depth + 1, false], [n, depth, true], [of.behind, depth + 1, false]);
    }
    const now = (step.numbers || []).find(([name]) => name == 'node');
    let html = '';
    for (const n of nodes.values())
      if (n.parent >= 0 && place.has(n.parent)) {
        const [a, b] = [place.get(n.parent), place.get(n.node)];
        html += `<line x1="${a[0]}" y1="${a[1]}" x2="${b[0]}" y2="${b[1]}" stroke="var(--quiet)"/>`;
      }
    for (const n of nodes.values()) {
      const [a, b] = place.get(n.node), fill = n.face >= 0 ? this.colour(n.face) : 'var(--panel)';
      const ink = n.face >= 0 ? ink_on(fill) : 'var(--ink)', is_now = now && now[1] == n.node;
      html += `<rect x="${a - 20}" y="${b - 11}" width="40" height="22" rx="5" fill="${fill}" stroke="${is_now ? 'var(--mark)' : 'var(--quiet)'}" stroke-width="${is_now ? 3 : 1}"/>` +
          `<text x="${a}" y="${b + 4}" text-anchor="middle" font-size="${n.text.length > 5 ? 8 : 12}" style="fill:${ink}">${escaped(n.text)}</text>`;
    }
    const w = 48 + 44 * Math.max(x - 1, 0), h = 40 + 40 * deepest;
    return `<svg width="${w}" height="${h}" viewBox="0 0 ${w} ${h}" role="img" aria-label="The tree of planes">${html}</svg>`;
  }
}
