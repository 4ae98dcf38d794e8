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
    if (result.colours) {
      check(picture.cells.length == result.colours.flat().length, where + ': not a colour for each sample');
      for (const [i, j, fill] of picture.cells)
        check(fill == result.colours[j][i], `${where}: sample ${i}, ${j} has not the library's colour`);
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
      check_labels(check, player, where());
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
    check_labels(check, player, where());
    check_cells(check, player, where());
    const slider = player.get('slider');
    slider.value = half;
    slider.dispatchEvent(new Event('input'));
    check(player.at == half && (middle == '' || shown(player).all == middle), where() + ': the slider shows another state than next');
    for (let clicks = 0; !back.disabled && clicks < run.steps.length + 5; ++clicks) back.click();
    check(player.at == 0 && shown(player).all == first, where() + ': back does not lead to the beginning');
  };

  const to_the_end = (player, k) => {
    player.get('run').value = k;
    player.get('run').dispatchEvent(new Event('change'));
    player.go(player.last);
    numbers_are_told(player, player.run.name);
    compare(player, player.run, player.run.name);
  };

  // Every choice of every part of the runs' names leads to a run that has it.
  const parts = player => {
    for (const select of player.parts || [])
      for (const option of select.options) {
        select.value = option.value;
        select.dispatchEvent(new Event('change'));
        check(player.run.name.split(', ').includes(option.value) && select.value == option.value && player.trace.runs[player.get('run').value] == player.run,
              `${option.value} is chosen, ${player.run.name} is shown`);
      }
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

  // The sliders of the near and the far plane: every pair, by its table, its plot and its sentence.
  const gaps = () => {
    const data = document.querySelector('script.gaps');
    if (!data) return;
    const {formats, rows} = JSON.parse(data.textContent), get = id => document.getElementById(id);
    const near = get('gap-near'), far = get('gap-far'), seen = new Set();
    check(near && far, 'no sliders of planes');
    for (near.value = 0; ; near.value = +near.value + 1) {
      for (far.value = 0; ; far.value = +far.value + 1) {
        near.dispatchEvent(new Event('input'));
        far.dispatchEvent(new Event('input'));
        const row = rows.find(r => r.near == get('gap-near-says').textContent && r.far == get('gap-far-says').textContent);
        const lines = [...get('gap-table').tBodies[0].rows].map(r => [...r.cells].map(c => c.textContent));
        check(row && lines.length == row.at.length && get('gap-plot').querySelectorAll('polyline').length == formats.length,
              'the planes of the sliders are not shown');
        row.at.forEach((at, k) => at.forEach((x, c) => check(x >= 1e9 || x < 1e-30 || Math.abs(+lines[k][c] - x) <= 0.006 * x, `a gap is ${lines[k][c]} for ${x}`)));
        check(near.getAttribute('aria-valuetext').includes(row.near), 'the slider does not say its plane');
        seen.add(get('gap-plot').innerHTML);
        if (+far.value == +far.max) break;
      }
      if (+near.value == +near.max) break;
    }
    check(seen.size == rows.length, `${seen.size} pictures of ${rows.length} pairs of planes`);
    for (const slider of [near, far]) {
      slider.focus();
      check(document.activeElement == slider, 'a slider cannot be reached by keyboard');
      const arrow = new KeyboardEvent('keydown', {key: 'ArrowRight', bubbles: true, cancelable: true});
      check(slider.dispatchEvent(arrow), 'an arrow key does not move the slider of a plane');
    }
    near.value = 2;
    far.value = 2;
    near.dispatchEvent(new Event('input'));
  };

  addEventListener('load', () => {
    try {
      for (const d of document.querySelectorAll('details')) {
        d.querySelector('summary').click();
        check(d.open, 'it does not unfold: ' + d.textContent.slice(0, 30));
      }
      const players = typeof Player == 'undefined' ? [] : Player.all;
      check(players.length > 0 || !document.querySelector('script.trace'), 'no player');
      check((players.length > 0) == document.getElementById('exercises').getClientRects().length > 0, 'a switch for exercises where there are none');
      for (const player of players) {
        // Of many long runs some are walked, and of the others the end is looked at.
        let walked = 0;
        player.trace.runs.forEach((run, k) => {
          if (walked < 3000 || k == player.trace.runs.length - 1) walk(player, k); else to_the_end(player, k);
          walked += run.steps.length;
        });
        parts(player);
        no_questions(player);
      }
      if (players.length) keyboard(players[0]);
      gaps();
      check_widths(check);
      for (const player of players) player.go(player.last >> 1);
      check_contrast(check, document.documentElement.dataset.theme);
      document.getElementById('theme').click();
      check_contrast(check, document.documentElement.dataset.theme);
      const links = [...document.querySelectorAll('[src],[href]')].map(e => e.getAttribute('src') || e.getAttribute('href'));
      check(!links.some(l => /^(https?:)?\/\//.test(l)), 'the page asks for something from elsewhere');
    } catch (e) {
      wrong.push('exception: ' + e + ' ' + e.stack);
    }
    parent.postMessage('PAGE ' + (wrong.length ? 'WRONG\n' + wrong.join('\n') : 'RIGHT') + '\n', '*');
  });
})();
