// Shows traces (hsr-trace/1, docs/explain.md) step by step. Every script element of class trace becomes a player in
// its place. Nothing of a method is computed here: the state after a step is what the changes of all steps before it make.
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
    get('code').innerHTML = trace.pseudocode.map(([name, text]) =>
      `<li data-line="${escaped(name)}"><span style="--indent:${text.search(/\S/)}">${escaped(text.trim())}</span></li>`).join('');
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
    this.cells_shown = new Map();  // by place: the cell of the state, and its element
    this.get('picture').querySelector('svg').innerHTML = '<g class="cells"></g><g class="over"></g>';
    // Where samples have numbers there is no room for names.
    this.get('legend').innerHTML = this.scene.samples && this.scene.faces.length <= 26 ?
        this.scene.faces.map(f => `<li style="--chip:${f.colour}">${escaped(f.name)}</li>`).join('') : '';
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
    if (this.of != this.run) {
      this.kept = [new State(this.scene)];
      this.of = this.run;
      this.at = Infinity;
    }
    if (k < this.at) {
      const last = Math.min(Math.floor((k + 1) / Player.stride), this.kept.length - 1);
      this.state = this.kept[last].copy();
      this.at = last * Player.stride - 1;
    }
    while (this.at < k) this.advance();
    this.show();
  }
  // The changes of one more step. Some states are kept, so that a step back is not all the way from the beginning.
  advance() {
    const changes = this.run.steps[++this.at].changes || [];
    for (const change of changes) this.state.apply(change);
    if (this.at == 0 || changes.some(change => change.do == 'piece' || change.do == 'drop')) this.state.settle();
    if ((this.at + 1) % Player.stride == 0) this.kept[(this.at + 1) / Player.stride] ??= this.state.copy();
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
    const diagrams = new Diagrams(this.scene.faces);
    let html = '';
    if (this.state.bars.size) html += diagrams.bars(this.state);
    for (const [name, masks] of this.state.masks) if (masks.length) html += diagrams.masks(name, masks);
    if (this.state.nodes.size) html += `<h4>the tree: above, what is nearer the root; left, behind the plane; right, in front</h4><div class="tree" tabindex="0">${diagrams.tree(this.state, step)}</div>`;
    for (const [name, items] of this.state.lists) {
      if (!items.length && name != 'painted') continue;
      html += `<h4>${escaped(name)}</h4><ul class="chips" tabindex="0">` +
          items.map(([text, face]) => `<li${face >= 0 ? ` style="--chip:${this.colour(face)}"` : ''}>${escaped(text)}</li>`).join('') + '</ul>';
    }
    if (html == this.lists_shown) return;
    this.lists_shown = this.get('lists').innerHTML = html;
    // The end of a long list is what changes. In the next frame, as the size of a list is known then.
    cancelAnimationFrame(this.scrolling);
    this.scrolling = requestAnimationFrame(() => {
      for (const list of this.get('lists').querySelectorAll('.chips')) list.scrollTop = list.scrollHeight;
    });
  }

  draw(step) {
    const svg = this.get('picture').querySelector('svg'), {width, height, faces, edges, samples} = this.scene;
    const unit = Math.max(width, height) / 100;  // a hundredth of the picture
    const state = this.state, painted = new Set(state.painted);
    svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
    let html = '';
    const with_pieces = state.pieces.size > 0;
    if (!with_pieces)
      for (const f of faces)
        for (const ring of f.rings)
          html += samples ? `<polygon class="outline" style="--of:${f.colour}" points="${points(ring)}" stroke-width="${unit * 0.4}"/>` :
                            `<polygon points="${points(ring)}" fill="${f.colour}" fill-opacity="0.14"/>`;
    for (const id of state.painted) {
      const p = state.pieces.get(id);
      if (p) html += `<polygon class="piece" points="${points(p.ring)}" fill="${this.colour(p.face)}" stroke-width="${unit * 0.2}"/>`;
    }
    for (const [id, p] of state.pieces)  // what waits is seen through
      if (!painted.has(id))
        html += `<polygon class="piece" points="${points(p.ring)}" fill="${this.colour(p.face)}" fill-opacity="0.14" stroke-width="${unit * 0.2}" stroke-opacity="0.7" stroke-dasharray="${unit} ${unit * 0.7}"/>`;
    if (edges.length) for (const e of edges) html += `<line class="edge" x1="${e.from[0]}" y1="${e.from[1]}" x2="${e.to[0]}" y2="${e.to[1]}" stroke-width="${unit * 0.2}"/>`;
    if (state.tiles) html += this.tiles_html(state.tiles, step.tiles || [], unit);
    for (const [a, b, is_hidden] of state.drawn)
      html += `<line class="drawn${is_hidden ? ' hidden' : ''}" x1="${a[0]}" y1="${a[1]}" x2="${b[0]}" y2="${b[1]}" stroke-width="${unit * (is_hidden ? 0.25 : 0.5)}"${is_hidden ? ` stroke-dasharray="${unit} ${unit * 0.8}"` : ''} stroke-linecap="round"/>`;
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
    svg.querySelector('.over').innerHTML = html + this.labels_html();
    this.draw_cells(svg.querySelector('.cells'));
  }

  // Samples: only those that another step has otherwise.
  draw_cells(group) {
    const shown = this.cells_shown, fresh = [];
    for (const [key, {element}] of shown)
      if (!this.state.cells.has(key)) element.remove(), shown.delete(key);
    for (const [key, cell] of this.state.cells) {
      const old = shown.get(key);
      if (old && old.cell != cell) old.element.innerHTML = this.cell_html(cell), old.cell = cell;
      if (!old) fresh.push([key, cell]);
    }
    const first = group.children.length;
    group.insertAdjacentHTML('beforeend', fresh.map(([, cell]) => `<g>${this.cell_html(cell)}</g>`).join(''));
    fresh.forEach(([key, cell], k) => shown.set(key, {cell, element: group.children[first + k]}));
  }
  cell_html([i, j, text, face, own]) {
    const fill = own || (face >= 0 ? this.colour(face) : 'var(--paper)'), size = Math.min(0.42, 1.4 / Math.max(text.length, 3));
    return `<rect class="cell" x="${i}" y="${j}" width="1" height="1" fill="${fill}" stroke-width="0.02"/>` +
        `<text x="${i + 0.5}" y="${j + 0.5 + size * 0.36}" text-anchor="middle" font-size="${size}" style="fill:${own || face >= 0 ? ink_on(fill) : 'var(--quiet)'}">${escaped(text)}</text>` +
        `<title>row ${j}, column ${i}: ${escaped(text)}${face >= 0 ? ', ' + escaped(this.scene.faces[face].name) : ''}</title>`;
  }

  // Those that hide something are shaded; of those that a step looks at, those that do not hide what it asks about have a cross.
  tiles_html({corner, column, row, columns, depths}, looked_at, unit) {
    const at = (i, j) => [0, 1].map(k => +(corner[k] + i * column[k] + j * row[k]).toFixed(2)).join(' ');
    const tile = (i, j) => `M${at(i, j)}L${at(i + 1, j)}L${at(i + 1, j + 1)}L${at(i, j + 1)}Z`;
    const cross = (i, j) => `M${at(i + 0.2, j + 0.2)}L${at(i + 0.8, j + 0.8)}M${at(i + 0.8, j + 0.2)}L${at(i + 0.2, j + 0.8)}`;
    const covering = depths.map((depth, k) => depth == null ? '' : tile(k % columns, Math.floor(k / columns))).join('');
    const path = (name, d) => d && `<path class="${name}" d="${d}" stroke-width="${unit * 0.25}"/>`;
    return path('covering', covering) + path('touched', looked_at.map(([i, j]) => tile(i, j)).join('')) +
        path('open', looked_at.filter(tile => !tile[2]).map(([i, j]) => cross(i, j)).join(''));
  }

  // Names are over all else. What is painted over a face hides its name.
  labels_html() {
    const {labels, pieces, painted} = this.state, rings = painted.map(id => pieces.get(id)?.ring || []);
    let html = '';
    for (const id of labels.placed.keys()) {
      const {at, text, size, leader} = labels.seen(id, painted.includes(id) ? rings.slice(painted.lastIndexOf(id) + 1) : []);
      if (!at) continue;
      if (leader) html += `<line class="leader" x1="${leader.a[0]}" y1="${leader.a[1]}" x2="${at[0]}" y2="${at[1]}" stroke-width="${size * 0.06}"/>`;
      html += `<text class="halo${this.state.vertices.has(id) ? ' vertex' : ''}" x="${at[0]}" y="${at[1] + size * 0.35}" text-anchor="middle" font-size="${size}" stroke-width="${size * 0.25}">${escaped(text)}</text>`;
    }
    return html;
  }
}
Player.all = [];
Player.stride = 16;  // steps from one kept state to the next
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
