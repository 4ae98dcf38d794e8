// Works a page of `hsr explain` as a reader would, who goes to the end of every run and back, answers wrong and then right, and takes
// the keyboard as well. Runs before the page's own scripts, so that it hears their errors too, and tells the page that it is framed
// by what went wrong.
(() => {
  const wrong = [];
  const check = (is_right, words) => { if (!is_right && wrong.length < 40) wrong.push(words); };
  addEventListener('error', e => wrong.push('error: ' + (e.message || 'a resource could not be loaded')), true);
  addEventListener('unhandledrejection', e => wrong.push('unhandled: ' + e.reason));
  for (const level of ['error', 'warn'])
    console[level] = (...words) => wrong.push('console.' + level + ': ' + words.join(' '));

  // What the picture of a player shows, by itself: the faces of cells, of painted pieces in their order, the lines that are drawn.
  const shown = player => {
    const svg = player.root.querySelector('.picture svg');
    return {
      cells: [...svg.querySelectorAll('rect.cell')].map(r => [+r.getAttribute('x'), +r.getAttribute('y'), r.getAttribute('fill')]),
      painted: [...svg.querySelectorAll('polygon.piece:not([stroke-dasharray])')].map(p => p.getAttribute('fill')),
      drawn: [...svg.querySelectorAll('line.drawn:not(.hidden)')].length,
      all: svg.innerHTML + player.root.querySelector('.lists').innerHTML,
    };
  };

  // The last picture is the library's result.
  const compare = (player, run, where) => {
    const picture = shown(player), result = run.result, colour = f => f >= 0 ? player.scene.faces[f].colour : 'var(--paper)';
    if (result.faces) {
      let count = 0;
      for (const [i, j, fill] of picture.cells) {
        ++count;
        check(fill == colour(result.faces[j][i]), `${where}: sample ${i}, ${j} is not as the library has it`);
      }
      check(count == 0 || count <= result.faces.length * result.faces[0].length, where + ': too many samples');
      check(count > 0 || result.faces.flat().every(f => f < 0), where + ': no samples');
    }
    if (result.painted) check(picture.painted.join() == result.painted.map(colour).join(), where + ': not painted in the library\'s order');
    if (result.lines) check(picture.drawn == result.lines.reduce((n, l) => n + l.visible.length, 0), where + ': not the library\'s lines');
    if (result.kept) check(player.state.lists.get('kept').map(item => item[1]).join() == result.kept.join(), where + ': not what the library keeps');
    if (result.nodes !== undefined) check(player.state.nodes.size == result.nodes, where + ': not the library\'s tree');
  };

  const numbers_are_told = (player, where) => {
    const step = player.run.steps[player.at];
    const cells = [...player.root.querySelectorAll('.numbers td:last-child')].map(c => c.textContent);
    const told = (step.numbers || []).map(n => n[1]);
    check(cells.length == told.length, `${where}: ${cells.length} numbers of ${told.length}`);
    told.forEach((x, k) => check(typeof x == 'number' ? Math.abs(+cells[k].replace('−', '-') - x) <= 1e-4 * Math.abs(x) : cells[k] == x,
                                 `${where}: ${cells[k]} is told for ${x}`));
    check(player.root.querySelector('.says').textContent == step.says, where + ': another sentence');
    const now = player.root.querySelectorAll('.code li.now');
    check(now.length == 1 && now[0].dataset.line == step.line, where + ': not the line of the pseudocode');
  };

  // By the buttons to the end, with answers, and back.
  const walk = (player, k) => {
    player.get('run').value = k;
    player.get('run').dispatchEvent(new Event('change'));
    const run = player.run, next = player.get('next'), back = player.get('back'), where = () => `${run.name}, step ${player.at + 1}`;
    const first = shown(player).all;
    let asked = 0, middle = '';
    const half = run.steps.length >> 1;
    for (let clicks = 0; !next.disabled && clicks < 3 * run.steps.length + 10; ++clicks) {
      numbers_are_told(player, where());
      if (player.at == half) middle = shown(player).all;
      next.click();
      if (!player.asking) continue;
      ++asked;
      const step = run.steps[player.at + 1], choices = [...player.get('choices').children], says = player.get('answer');
      check(choices.length == step.choices.length, where() + ': not all choices');
      check(player.get('says').textContent != step.says, where() + ': the answer is given away');
      choices[(step.right + 1) % choices.length].click();
      check(says.classList.contains('wrong') && says.textContent, where() + ': a wrong answer is not told');
      choices[step.right].click();
      check(says.classList.contains('right'), where() + ': the right answer is not told');
      check(player.answered.get(player.at + 1) === false, where() + ': the second try counts');
      next.click();
    }
    check(player.at == run.steps.length - 1, where() + ': the end is not reached');
    check(asked == run.steps.filter(s => s.choices).length, where() + ': not every question was asked');
    compare(player, run, run.name);
    const slider = player.get('slider');
    slider.value = half;
    slider.dispatchEvent(new Event('input'));
    check(player.at == half && (middle == '' || shown(player).all == middle), where() + ': the slider shows another state than next');
    for (let clicks = 0; !back.disabled && clicks < run.steps.length + 5; ++clicks) back.click();
    check(player.at == 0 && shown(player).all == first, where() + ': back does not lead to the beginning');
  };

  const no_questions = player => {
    const box = document.getElementById('exercises');
    box.click();
    player.choose(0);
    while (!player.get('next').disabled) {
      player.get('next').click();
      check(!player.asking, 'a question, though exercises are off');
      if (player.asking) break;
    }
    box.click();
  };

  const keyboard = player => {
    const press = key => document.body.dispatchEvent(new KeyboardEvent('keydown', {key, bubbles: true, cancelable: true}));
    player.choose(0);
    player.get('next').focus();
    check(document.activeElement == player.get('next'), 'next cannot be reached by keyboard');
    press('End');
    check(player.at == player.last, 'End does not go to the end');
    press('ArrowLeft');
    check(player.at == Math.max(0, player.last - 1), 'the left arrow does not go back');
    press('Home');
    check(player.at == 0, 'Home does not go to the beginning');
    const k = player.run.steps.findIndex(s => s.choices);
    if (k > 0) {
      player.go(k - 1);
      press('ArrowRight');
      check(player.asking, 'the right arrow does not come to the question');
      press(String(player.run.steps[k].right + 1));
      check(player.answered.get(k) === true, 'a digit does not answer');
      press('ArrowRight');
      check(player.at == k, 'the right arrow does not go on');
    }
    press(' ');
    check(player.timer != 0, 'space does not play');
    press(' ');
    check(player.timer == 0, 'space does not stop');
    for (const e of document.querySelectorAll('button, select, input, a, summary')) {
      if (e.disabled || e.closest('[hidden]')) continue;
      e.focus();
      check(document.activeElement == e || e.getClientRects().length == 0, 'cannot be reached by keyboard: ' + (e.textContent || e.className).slice(0, 40));
    }
  };

  // Of text to what is behind it: 4.5 by WCAG 2, AA.
  const contrast = theme => {
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

  addEventListener('load', () => {
    try {
      for (const d of document.querySelectorAll('details')) {
        d.querySelector('summary').click();
        check(d.open, 'it does not unfold: ' + d.textContent.slice(0, 30));
      }
      const players = typeof Player == 'undefined' ? [] : Player.all;
      check(players.length > 0 || !document.querySelector('script.trace'), 'no player');
      for (const player of players) {
        player.trace.runs.forEach((run, k) => walk(player, k));
        no_questions(player);
      }
      if (players.length) keyboard(players[0]);
      const wide = document.documentElement.scrollWidth;
      check(wide <= innerWidth, `the page is ${wide} wide, the window ${innerWidth}`);
      for (const player of players) player.go(player.last >> 1);
      contrast(document.documentElement.dataset.theme);
      document.getElementById('theme').click();
      contrast(document.documentElement.dataset.theme);
      const links = [...document.querySelectorAll('[src],[href]')].map(e => e.getAttribute('src') || e.getAttribute('href'));
      check(!links.some(l => /^(https?:)?\/\//.test(l)), 'the page asks for something from elsewhere');
    } catch (e) {
      wrong.push('exception: ' + e + ' ' + e.stack);
    }
    parent.postMessage('PAGE ' + (wrong.length ? 'WRONG\n' + wrong.join('\n') : 'RIGHT') + '\nEND', '*');
  });
})();
