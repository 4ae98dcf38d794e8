// What a trace has come to after a step, and what all pictures of it are made with.
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
  constructor({width, height, faces, edges, samples}) {
    this.faces = samples ? [] : faces;
    // Edges are named by their vertices: 3–7.
    this.vertices = new Map(edges.length > 100 ? [] : edges.flatMap(({name, from, to}) => name.split('–').map((v, k) => ['vertex ' + v, {text: v, ring: [k ? to : from]}])));
    this.labels = new Labels(width, height, Math.max(width, height) * 0.036);
    this.lists = new Map();
    this.pieces = new Map();
    this.painted = [];
    this.cells = new Map();
    this.nodes = new Map();
    this.bars = new Map();
    this.masks = new Map();
    this.drawn = [];
    this.tiles = null;
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
      case 'tiles': this.tiles = change; break;
    }
  }
  // Another one, which changes by itself: what is in a map is replaced, never changed.
  copy() {
    const other = Object.assign(Object.create(State.prototype), this);
    for (const name of ['lists', 'pieces', 'cells', 'nodes', 'bars', 'masks']) other[name] = new Map(this[name]);
    other.painted = [...this.painted];
    other.drawn = [...this.drawn];
    other.labels = this.labels.copy();
    return other;
  }
  // The changes of a step are made: names are placed here, so that they are where they are however a reader came to the step.
  settle() {
    const pieces = [...this.pieces].map(([id, p]) => [id, {text: p.name, ring: p.ring}]);
    const faces = this.faces.flatMap((f, k) => f.rings.map(ring => ['face ' + k, {text: f.name, ring}]));
    this.labels.settle(new Map([...(pieces.length ? pieces : faces), ...this.vertices]));
  }
}
