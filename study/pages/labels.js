// Where the names of faces stand in a picture: each within its face if it has room there, off other faces and lines if that can be, and
// none over another. Numbers of vertices stand beside these. What is too small for its name has it beside it, at the end of a line.
const inside = (ring, [x, y]) => ring.reduce((is_in, [ax, ay], k) => {
  const [bx, by] = ring[(k + 1) % ring.length];
  return (ay > y) != (by > y) && x < ax + (bx - ax) * (y - ay) / (by - ay) ? !is_in : is_in;
}, false);
const apart = (a, b) => a[2] <= b[0] || b[2] <= a[0] || a[3] <= b[1] || b[3] <= a[1];
function around(ring) {
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [x, y] of ring) {
    box[0] = Math.min(box[0], x), box[1] = Math.min(box[1], y);
    box[2] = Math.max(box[2], x), box[3] = Math.max(box[3], y);
  }
  return box;
}

// A line from a to b, with a box around it; whether it passes through another one.
const line_of = (a, b) => ({a, b, box: around([a, b])});
function crosses(box, {a, b, box: own}) {
  if (apart(box, own)) return false;
  const side = (x, y) => (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
  const sides = [side(box[0], box[1]), side(box[2], box[1]), side(box[2], box[3]), side(box[0], box[3])];
  return !sides.every(s => s > 0) && !sides.every(s => s < 0);
}

class Labels {
  constructor(width, height, size) {
    Object.assign(this, {width, height, size, placed: new Map()});
  }

  copy() {
    const other = Object.assign(Object.create(Labels.prototype), this);
    other.placed = new Map(this.placed);
    return other;
  }

  // Places those of these names that are new, the smallest faces first; what is not among them goes. @param names id to {text, ring}
  settle(names) {
    for (const id of this.placed.keys())
      if (names.get(id)?.ring != this.placed.get(id).ring) this.placed.delete(id);
    const area = ring => { const [x, y, x2, y2] = around(ring); return (x2 - x) * (y2 - y); };
    const fresh = [...names].filter(([id]) => !this.placed.has(id)).sort((a, b) => area(a[1].ring) - area(b[1].ring));
    this.rings = [...names.values()].map(name => name.ring).filter(ring => ring.length > 2);
    this.lines = this.rings.flatMap(ring => ring.map((p, k) => line_of(p, ring[(k + 1) % ring.length])));
    for (const [id, {text, ring}] of fresh) this.placed.set(id, {text, ring, ...this.find(text, ring, [])});
  }

  // The place of a name, if what is over its face leaves any of it: {at, size, box, leader}.
  seen(id, over) {
    const label = this.placed.get(id), is_seen = p => !over.some(ring => inside(ring, p));
    if (!label.at || is_seen(label.leader ? label.leader.a : label.at)) return label;
    return {...label, ...this.find(label.text, label.ring, over)};
  }

  find(text, ring, over) {
    const size = this.size * (text.length > 4 ? 0.75 : 1) * (this.rings.length > 60 ? 0.6 : this.rings.length > 26 ? 0.75 : 1), centre = middle(ring), [x, y, x2, y2] = around(ring), n = this.rings.length > 60 ? 4 : 10;
    if (ring.length == 1) return this.find_beside(text, ring);
    let within = [centre];
    for (let i = 0; i <= n; ++i)
      for (let j = 0; j <= n; ++j) within.push([x + (x2 - x) * (i + 0.5) / (n + 1), y + (y2 - y) * (j + 0.5) / (n + 1)]);
    within = within.filter(p => inside(ring, p) && !over.some(o => inside(o, p)));
    const nothing = {at: null, size, box: [0, 0, 0, 0], leader: null};
    if (!within.length) return nothing;
    const far = p => Math.hypot(p[0] - centre[0], p[1] - centre[1]) / this.size;
    let best = nothing, least = Infinity;
    const offer = (at, leader, more) => {
      const cost = this.cost(at, text, size, ring, leader) + more;
      if (cost < least) least = cost, best = {at, size, box: this.box(at, text, size), leader};
    };
    for (const p of within) offer(p, null, far(p) / 4);
    // Its own sides cross it, or there is another name. Where there are many names, so are their lines: then rather within.
    const beside = 3 + Math.max(0, this.rings.length - 16) / 5;
    if (least >= beside) {
      // The line leads to where few other faces are.
      const around_it = p => far(p) / 4 + 2 * this.rings.filter(face => inside(face, p)).length;
      const anchor = within.reduce((a, p) => around_it(p) < around_it(a) ? p : a);
      for (let k = 0; k < 80; ++k) {
        const turn = Math.PI * k / 8, reach = [1.6, 2.6, 4.6, 7.6, 11][k >> 4] * size;
        const at = [(x + x2) / 2 + Math.cos(turn) * ((x2 - x) / 2 + reach), (y + y2) / 2 - Math.sin(turn) * ((y2 - y) / 2 + reach)];
        offer(at, line_of(anchor, at), beside + far(at) / 4);
      }
    }
    return best;
  }

  // The number of a vertex, without a line.
  find_beside(text, ring) {
    const size = this.size * 0.6, [[x, y]] = ring;
    let best = {at: null, size, box: [0, 0, 0, 0], leader: null}, least = Infinity;
    for (let k = 0; k < 32; ++k) {
      const turn = Math.PI * k / 8, reach = size * [1, 1.5][k >> 4], at = [x + Math.cos(turn) * reach * (0.6 + 0.3 * text.length), y - Math.sin(turn) * reach];
      const cost = this.cost(at, text, size, ring, null) + (k >> 4);
      if (cost < least) least = cost, best = {at, size, box: this.box(at, text, size), leader: null};
    }
    return best;
  }

  box([x, y], text, size) {
    const w = size * (0.2 + 0.31 * text.length), h = size * 0.55;
    return [x - w, y - h, x + w, y + h];
  }

  // How much is in the way of a name: lines, and faces around it that are not its own. Infinity: another name, or the edge of the picture.
  cost(at, text, size, ring, leader) {
    const box = this.box(at, text, size), others = [...this.placed.values()].filter(label => label.at && label.ring != ring);
    if (box[0] < 0 || box[1] < 0 || box[2] > this.width || box[3] > this.height) return Infinity;
    if (others.some(o => !apart(box, o.box) || leader && crosses(o.box, leader) || o.leader && crosses(box, o.leader))) return Infinity;
    const crossed = this.lines.filter(line => crosses(box, line)), own = crossed.filter(line => ring.includes(line.a)).length;
    return own * 2 + (crossed.length - own) * 1.25 + (this.rings.filter(face => inside(face, at)).length - (leader ? 0 : 1)) * 2;
  }
}
