// Shows traces (hsr-trace/1, docs/explain.md) step by step. Every script element of class trace becomes a player in
// its place. Nothing of a method is computed here: the state after a step is what the changes of all steps before it make.
const escaped = text => String(text).replace(/[&<>"]/g, c => ({'&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;'}[c]));
const points = ring => ring.map(p => p.join(',')).join(' ');
const number_text = x => typeof x == 'number' ? String(+x.toPrecision(5)).replace('-', '−') : x;

// The ink that is read on a colour.
function ink_on(colour) {
  const channel = k => { const c = parseInt(colour.slice(k, k + 2), 16) / 255; return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4; };
  const light = 0.2126 * channel(1) + 0.7152 * channel(3) + 0.0722 * channel(5);
  return (light + 0.05) / 0.05 > 1.05 / (light + 0.05) ? '#000' : '#fff';
}

// Where a name stands: the middle of the corners.
function middle(ring) {
  const sum = ring.reduce((s, p) => [s[0] + p[0], s[1] + p[1]], [0, 0]);
  return sum.map(x => x / ring.length);
}

class State {
  constructor() {
    this.lists = new Map();
    this.pieces = new Map();
    this.painted = [];
    this.cells = new Map();
    this.nodes = new Map();
    this.bars = new Map();
    this.masks = new Map();
    this.drawn = [];
  }
  apply(change) {
    switch (change.do) {
      case 'list': this.lists.set(change.name, change.items); break;
      case 'add': this.lists.set(change.name, [...(this.lists.get(change.name) || []), change.item]); break;
      case 'piece': this.pieces.set(change.piece, change); break;
      case 'drop': this.pieces.delete(change.piece); break;
      case 'paint': this.painted.push(change.piece); break;
      case 'unpaint': this.painted = []; break;
      case 'cells': for (const c of change.cells) this.cells.set(c[0] + ',' + c[1], c); break;
      case 'node': this.nodes.set(change.node, change); break;
      case 'bars': this.bars.set(change.name, change.bars); break;
      case 'masks': this.masks.set(change.name, change.masks); break;
      case 'draw': this.drawn.push(...change.lines); break;
      case 'undraw': this.drawn = []; break;
    }
  }
}

class Player {
  constructor(place, trace) {
    this.trace = trace;
    this.root = document.getElementById('player').content.cloneNode(true).querySelector('.player');
    const get = name => this.root.querySelector('.' + name);
    this.get = get;
    trace.runs.forEach((run, k) => get('run').add(new Option(run.name, k)));
    get('runs').hidden = trace.runs.length < 2;
    this.make_parts();
    get('run').addEventListener('change', () => this.choose(+get('run').value));
    get('code').innerHTML = trace.pseudocode.map(([name, text]) => `<li data-line="${escaped(name)}">${escaped(text)}</li>`).join('');
    get('first').addEventListener('click', () => this.go(0));
    get('back').addEventListener('click', () => this.back());
    get('next').addEventListener('click', () => this.next());
    get('play').addEventListener('click', () => this.play(!this.timer));
    get('slider').addEventListener('input', () => this.go(+get('slider').value));
    this.root.addEventListener('focusin', () => { Player.last = this; });
    this.root.addEventListener('pointerdown', () => { Player.last = this; });
    place.replaceWith(this.root);
    Player.all.push(this);
    this.choose(0);
  }

  // Runs whose names are "format, function, ..." are chosen by a select for each part; the select of whole names is hidden then.
  make_parts() {
    const names = this.trace.runs.map(run => run.name.split(', ')), count = names[0].length;
    const parts = names[0].map((_, p) => [...new Set(names.map(name => name[p]))]);
    if (count < 2 || names.length < 8 || names.some(name => name.length != count)) return;
    this.parts = parts.map((options, p) => {
      const select = document.createElement('select');
      select.setAttribute('aria-label', ['How depths are stored', 'The test', 'Where depths come from'][p] || `Choice ${p + 1}`);
      for (const name of options) select.add(new Option(name, name));
      // The run with this part, and as many as can be of the others.
      select.addEventListener('change', () => {
        const wanted = this.parts.map(part => part.value);
        const fit = name => name[p] == wanted[p] ? name.filter((part, q) => part == wanted[q]).length : -1;
        this.choose(names.reduce((best, name, k) => fit(name) > fit(names[best]) ? k : best, 0));
      });
      return select;
    });
    this.get('runs').querySelector('label').hidden = true;
    this.get('runs').append('Show ', ...this.parts);
  }

  choose(k) {
    this.stop();
    this.get('run').value = k;
    if (this.parts) this.trace.runs[k].name.split(', ').forEach((part, p) => { this.parts[p].value = part; });
    this.run = this.trace.runs[k];
    this.scene = this.run.scene || this.trace.scene;
    this.answered = new Map();  // by step: whether the first answer was right
    this.asking = false;
    this.get('slider').max = this.run.steps.length - 1;
    this.get('all-steps').innerHTML = this.run.steps.map(s => `<li>${escaped(s.says)}</li>`).join('');
    this.go(0);
  }

  get last() { return this.run.steps.length - 1; }
  // After step k; where a question stands before step k + 1, that is asked by next().
  go(k) {
    this.asking = false;
    k = Math.max(0, Math.min(this.last, k));
    if (!this.state || this.of != this.run || k < this.at) {
      this.state = new State();
      this.at = -1;
      this.of = this.run;
    }
    while (this.at < k) for (const change of this.run.steps[++this.at].changes || []) this.state.apply(change);
    this.show();
  }
  back() {
    this.stop();
    if (this.asking) { this.asking = false; this.show(); return; }
    this.go(this.at - 1);
  }
  next() {
    if (this.at == this.last) { this.stop(); return; }
    const step = this.run.steps[this.at + 1];
    if (!this.asking && step.choices && exercises.checked && !this.answered.has(this.at + 1)) {
      this.asking = true;
      this.stop();
      this.show();
      return;
    }
    this.go(this.at + 1);
  }
  answer(k) {
    const step = this.run.steps[this.at + 1], buttons = this.get('choices').children;
    const is_right = k == step.right;
    if (!this.answered.has(this.at + 1)) this.answered.set(this.at + 1, is_right);
    buttons[k].classList.add(is_right ? 'is-right' : 'is-wrong');
    const says = this.get('answer');
    says.className = 'answer ' + (is_right ? 'right' : 'wrong');
    says.textContent = is_right ? '✓ Right. Next shows the step.' : '✗ Not so. Try again, or see the step with next.';
    this.score();
  }
  score() {
    const right = [...this.answered.values()].filter(x => x).length, all = this.run.steps.filter(s => s.choices).length;
    this.get('score').textContent = exercises.checked && all ? `${right} of ${all} right` : '';
  }
  play(on) {
    this.stop();
    if (!on) return;
    if (this.at == this.last) this.go(0);
    this.timer = setInterval(() => this.next(), +this.get('speed').querySelector('select').value);
    this.get('play').lastChild.textContent = ' stop';
  }
  stop() {
    clearInterval(this.timer);
    this.timer = 0;
    this.get('play').lastChild.textContent = ' play';
  }

  show() {
    const step = this.run.steps[this.at], asked = this.asking ? this.run.steps[this.at + 1] : null, get = this.get;
    get('count').textContent = `Step ${this.at + 1} of ${this.last + 1}`;
    get('says').textContent = asked ? 'What happens next?' : step.says;
    get('slider').value = this.at;
    get('slider').setAttribute('aria-valuetext', `step ${this.at + 1} of ${this.last + 1}`);
    get('back').disabled = this.at == 0 && !this.asking;
    get('first').disabled = this.at == 0;
    get('next').disabled = this.at == this.last;
    get('question').hidden = !asked;
    if (asked) {
      get('asked').textContent = asked.question;
      get('answer').textContent = '';
      get('choices').replaceChildren(...asked.choices.map((text, k) => {
        const button = document.createElement('button');
        button.type = 'button';
        button.textContent = `${k + 1}: ${text}`;
        button.addEventListener('click', () => this.answer(k));
        return button;
      }));
    }
    get('numbers').tBodies[0].innerHTML =
        (step.numbers || []).map(([name, x]) => `<tr><td>${escaped(name)}</td><td>${escaped(number_text(x))}</td></tr>`).join('');
    for (const line of get('code').children) {
      const is_now = line.dataset.line == step.line;
      line.classList.toggle('now', is_now);
      if (is_now) line.setAttribute('aria-current', 'step'); else line.removeAttribute('aria-current');
    }
    this.show_lists(step);
    this.draw(step);
    this.score();
  }

  colour(face) { return face >= 0 ? this.scene.faces[face].colour : 'var(--panel)'; }

  show_lists(step) {
    let html = '';
    if (this.state.bars.size) html += this.bars_html();
    for (const [name, masks] of this.state.masks) if (masks.length) html += this.masks_html(name, masks);
    if (this.state.nodes.size) html += `<h4>the tree: above, what is nearer the root; left, behind the plane; right, in front</h4><div class="tree" tabindex="0">${this.tree_svg(step)}</div>`;
    for (const [name, items] of this.state.lists) {
      if (!items.length && name != 'painted') continue;
      html += `<h4>${escaped(name)}</h4><ul class="chips" tabindex="0">` +
          items.map(([text, face]) => `<li${face >= 0 ? ` style="--chip:${this.colour(face)}"` : ''}>${escaped(text)}</li>`).join('') + '</ul>';
    }
    this.get('lists').innerHTML = html;
    for (const list of this.get('lists').querySelectorAll('.chips')) list.scrollTop = list.scrollHeight;
  }

  bars_html() {
    let html = '', rows = '', y = 0;
    const row = (name, from, to, fill, face) => {
      const a = 20 + 260 * Math.max(0, Math.min(1, from)), b = 20 + 260 * Math.max(0, Math.min(1, to));
      rows += `<rect x="${a}" y="${y + 2}" width="${Math.max(b - a, 0.8)}" height="9" fill="${fill}"><title>${escaped(name)} ${number_text(from)} … ${number_text(to)}</title></rect>`;
      if (face >= 0) rows += `<text x="${b + 2}" y="${y + 10}" font-size="9">${escaped(this.scene.faces[face].name)}</text>`;
    };
    for (const [name, bars] of this.state.bars) {
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
  masks_html(name, masks) {
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
  tree_svg(step) {
    const nodes = this.state.nodes, children = new Map(), place = new Map();
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

  draw(step) {
    const svg = this.get('picture').querySelector('svg'), {width, height, faces, edges, samples} = this.scene;
    const unit = Math.max(width, height) / 100;  // a hundredth of the picture
    const state = this.state, painted = new Set(state.painted);
    svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
    let html = '';
    for (const [i, j, text, face, own] of state.cells.values()) {
      const fill = own || (face >= 0 ? this.colour(face) : 'var(--paper)'), size = Math.min(0.42, 1.7 / Math.max(text.length, 3));
      html += `<g><rect class="cell" x="${i}" y="${j}" width="1" height="1" fill="${fill}" stroke-width="0.02"/>` +
          `<text x="${i + 0.5}" y="${j + 0.5 + size * 0.36}" text-anchor="middle" font-size="${size}" style="fill:${own || face >= 0 ? ink_on(fill) : 'var(--quiet)'}">${escaped(text)}</text>` +
          `<title>row ${j}, column ${i}: ${escaped(text)}${face >= 0 ? ', ' + escaped(faces[face].name) : ''}</title></g>`;
    }
    const label = (ring, text, size) => {
      const [x, y] = middle(ring);
      return `<text class="halo" x="${x}" y="${y + size * 0.35}" text-anchor="middle" font-size="${size}" stroke-width="${size * 0.25}">${escaped(text)}</text>`;
    };
    const with_pieces = state.pieces.size > 0;
    if (!with_pieces)
      for (const f of faces)
        for (const ring of f.rings)
          html += samples ? `<polygon class="outline" points="${points(ring)}" stroke-width="${unit * 0.25}"/>` :
                            `<polygon points="${points(ring)}" fill="${f.colour}" fill-opacity="0.14"/>`;
    const size = unit * (faces.length > 60 ? 2.2 : 3.6), of_piece = p => label(p.ring, p.name, p.name.length > 4 ? size * 0.75 : size);
    for (const id of state.painted) {
      const p = state.pieces.get(id);
      if (p) html += `<polygon class="piece" points="${points(p.ring)}" fill="${this.colour(p.face)}" stroke-width="${unit * 0.2}"/>` + of_piece(p);
    }
    for (const [id, p] of state.pieces)  // what waits is seen through
      if (!painted.has(id))
        html += `<polygon class="piece" points="${points(p.ring)}" fill="${this.colour(p.face)}" fill-opacity="0.14" stroke-width="${unit * 0.2}" stroke-opacity="0.7" stroke-dasharray="${unit} ${unit * 0.7}"/>` + of_piece(p);
    if (edges.length) for (const e of edges) html += `<line class="edge" x1="${e.from[0]}" y1="${e.from[1]}" x2="${e.to[0]}" y2="${e.to[1]}" stroke-width="${unit * 0.2}"/>`;
    for (const [a, b, is_hidden] of state.drawn)
      html += `<line class="drawn${is_hidden ? ' hidden' : ''}" x1="${a[0]}" y1="${a[1]}" x2="${b[0]}" y2="${b[1]}" stroke-width="${unit * (is_hidden ? 0.25 : 0.5)}"${is_hidden ? ` stroke-dasharray="${unit} ${unit * 0.8}"` : ''} stroke-linecap="round"/>`;
    if (!with_pieces && !samples)
      for (const f of faces) for (const ring of f.rings) html += label(ring, f.name, size);
    if (step.row !== undefined) html += `<rect class="row" x="0" y="${step.row}" width="${width}" height="1" stroke-width="${unit * 0.4}"/>`;
    const lit = (ring) => `<polygon class="lit" points="${points(ring)}" stroke-width="${unit * 0.8}"/>`;
    for (const f of step.faces || []) for (const ring of faces[f].rings) html += lit(ring);
    for (const id of step.pieces || []) if (state.pieces.has(id)) html += lit(state.pieces.get(id).ring);
    for (const k of step.edges || []) {
      const e = edges[k];
      html += `<line class="mark" x1="${e.from[0]}" y1="${e.from[1]}" x2="${e.to[0]}" y2="${e.to[1]}" stroke-width="${unit * 0.5}"/>`;
    }
    for (const [a, b] of step.marks || [])
      html += `<line class="mark" x1="${a[0]}" y1="${a[1]}" x2="${b[0]}" y2="${b[1]}" stroke-width="${unit}" stroke-linecap="round"/>`;
    svg.innerHTML = html;
  }
}
Player.all = [];
Player.last = null;

// A teacher may give out the address with #no-exercises.
const exercises = document.getElementById('exercises');
if (location.hash == '#no-exercises') exercises.checked = false;
exercises.addEventListener('change', () => {
  for (const player of Player.all) {
    player.asking = false;
    player.show();
  }
});

for (const place of document.querySelectorAll('script.trace')) new Player(place, JSON.parse(place.textContent));

addEventListener('keydown', event => {
  const player = Player.last || Player.all[0];
  if (!player || event.altKey || event.ctrlKey || event.metaKey || event.target.closest('select, input:not([type=range])')) return;
  const at_slider = event.target.matches('input[type=range]');
  const act = {
    ArrowRight: () => player.next(), ArrowLeft: () => player.back(), Home: () => player.go(0), End: () => player.go(player.last),
    ' ': () => player.play(!player.timer),
  }[event.key];
  const is_pressed = event.key == ' ' && event.target.closest('button, summary, a');
  if (act && !at_slider && !is_pressed && !event.target.closest('.chips, .tree, .scroll')) {
    act();
    event.preventDefault();
  } else if (player.asking && /^[1-9]$/.test(event.key)) {
    const choice = player.get('choices').children[+event.key - 1];
    if (choice) choice.click();
  }
});
