// Two methods beside each other, the left one over the whole picture at first: `shown` has them all, the exact picture first.
const get = id => document.getElementById(id), left = get('left'), right = get('right');
const empty = 'data:image/gif;base64,R0lGODlhAQABAAAAACH5BAEKAAEALAAAAAABAAEAAAICTAEAOw==';
shown.forEach((m, k) => { for (const s of [left, right]) s.add(new Option(m.name, k)); });
left.value = Math.min(1, shown.length - 1);
right.value = 0;
get('truth').src = shown[0].picture;

// What differs, in words; of a pair that is the same, another one that is not.
function say() {
  const l = shown[left.value], r = shown[right.value], says = get('pair-says');
  const same = l == r || l.wrong == 0 && r.wrong == 0 || l.changes != '' && l.changes == r.changes;
  says.textContent = same ? `“${l.name}” and “${r.name}” show the same face at every sample.` :
      `“${l.name}” shows another face than the nearest at ${l.wrong} of ${l.covered} samples, “${r.name}” at ${r.wrong}.`;
  if (!same) return;
  const other = shown.reduce((best, m) => m.wrong > best.wrong ? m : best);
  if (other.wrong == 0) {
    says.textContent += ' So does every method here: the scene is an easy one.';
    return;
  }
  const button = document.createElement('button');
  button.type = 'button';
  button.id = 'another';
  button.textContent = `Show “${other.name}”, which is wrong at ${other.wrong}`;
  button.addEventListener('click', () => {
    left.value = shown.indexOf(other);
    right.value = 0;
    draw();
  });
  says.append(' ', button);
}

function draw() {
  const what = document.querySelector('input[name=what]:checked').value, at = get('position').value;
  get('pair').classList.toggle('pale', what == 'mistakes');
  for (const [id, s] of [['l', left], ['r', right]]) {
    const m = shown[s.value];
    get(id).src = what == 'picture' ? m.changes || empty : what == 'mistakes' ? m.mistakes || empty : m.depth || empty;
    get('says-' + id).textContent = m.says + (get(id).src != empty || m == shown[0] ? '' : m.large ? ' (left out, or the page would be too large: see the directory pictures)' : what == 'depth' ? ' (has no depths)' : '');
  }
  get('l').style.clipPath = 'inset(0 ' + (100 - at) + '% 0 0)';
  get('r').style.clipPath = 'inset(0 0 0 ' + at + '%)';
  get('bar').style.left = 'calc(' + at + '% - 1px)';
  say();
}
for (const e of [left, right, get('position'), ...document.querySelectorAll('input[name=what]')]) e.addEventListener('input', draw);
get('pair').addEventListener('pointermove', e => {
  if (!e.buttons) return;
  const b = get('pair').getBoundingClientRect();
  get('position').value = 100 * (e.clientX - b.left) / b.width;
  draw();
  e.preventDefault();
});
draw();
