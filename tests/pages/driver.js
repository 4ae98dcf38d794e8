// Works a page of hsr as a reader would: every head of every table, the theme, and the slider where there is one. Runs before the
// page's own scripts, so that it hears their errors too, and tells the page that it is framed by what went wrong.
(() => {
  const wrong = [];
  const check = (is_right, words) => { if (!is_right) wrong.push(words); };
  addEventListener('error', e => wrong.push('error: ' + (e.message || 'a resource could not be loaded')), true);
  addEventListener('unhandledrejection', e => wrong.push('unhandled: ' + e.reason));
  for (const level of ['error', 'warn'])
    console[level] = (...words) => wrong.push('console.' + level + ': ' + words.join(' '));

  // Of each group of rows.
  const values = (table, column) => [...table.tBodies].map(body => [...body.rows].filter(r => !r.classList.contains('group')).map(r => {
    const c = r.cells[column];
    return 'v' in c.dataset ? +c.dataset.v : c.textContent;
  }));
  const is_sorted = (list, up) => list.every((x, k) => {
    if (k == 0) return true;
    const y = list[k - 1], d = typeof x == 'number' && typeof y == 'number' ? x - y : String(x).localeCompare(String(y));
    return up ? d >= 0 : d <= 0;
  });

  // What a page folds away a reader unfolds.
  const details = () => {
    for (const d of document.querySelectorAll('details')) {
      d.querySelector('summary').click();
      check(d.open, 'it does not unfold: ' + d.textContent.slice(0, 30));
    }
  };

  const tables = () => {
    check(document.querySelectorAll('table').length > 0, 'there is no table');
    for (const table of document.querySelectorAll('table'))
      table.querySelectorAll('th button').forEach((button, column) => {
        if (!button.getClientRects().length) return;  // left out where the screen is narrow
        const rows = table.rows.length;
        for (const up of [true, false]) {
          button.focus();
          check(document.activeElement == button, 'a head cannot be reached by keyboard: ' + button.textContent);
          button.click();
          check(button.parentElement.getAttribute('aria-sort') == (up ? 'ascending' : 'descending'), 'no aria-sort: ' + button.textContent);
          check(values(table, column).every(group => is_sorted(group, up)), 'not sorted: ' + button.textContent);
        }
        check(table.rows.length == rows, 'sorting changed the number of rows');
      });
  };

  const theme = () => {
    const button = document.getElementById('theme'), root = document.documentElement;
    const paper = () => getComputedStyle(document.body).backgroundColor;
    const before = root.dataset.theme, colour = paper();
    button.click();
    check(root.dataset.theme != before && paper() != colour, 'the theme does not change');
    button.click();
    check(root.dataset.theme == before && paper() == colour, 'the theme does not change back');
  };

  // The width and height that a picture within the page has, or nothing.
  const size_of = url => {
    const [head, data] = url.split(',');
    const bytes = head == 'data:image/png;base64' ? atob(data) : '';
    const number = at => [0, 1, 2, 3].reduce((n, k) => 256 * n + bytes.charCodeAt(at + k), 0);
    return bytes.slice(1, 4) == 'PNG' && bytes.endsWith('IEND\xaeB`\x82') ? number(16) + ' x ' + number(20) : '';
  };

  const slider = () => {
    const get = id => document.getElementById(id), left = get('left');
    if (!left) return;
    // It opens on what the left method shows wrong, all over the picture; of a pair that is the same it offers another.
    check(document.querySelector('input[name=what]:checked').value == 'mistakes' && get('position').value == 100, 'it does not open on what differs');
    check(get('l').src.startsWith('data:image/png') && get('pair-says').textContent != '', 'it says not what differs');
    left.value = 0;
    left.dispatchEvent(new Event('input', {bubbles: true}));
    check(get('pair-says').textContent.includes('same'), 'it says not that two are the same');
    if (shown.some(m => m.wrong > 0)) {
      get('another').click();
      check(shown[left.value].wrong == Math.max(...shown.map(m => m.wrong)), 'it offers not what differs most');
    }
    check(left.options.length > 1, 'there is nothing to compare');
    const fire = e => e.dispatchEvent(new Event('input', {bubbles: true}));
    for (const what of ['picture', 'mistakes', 'depth'])
      for (let k = 0; k < left.options.length; ++k) {
        document.querySelector('input[name=what][value=' + what + ']').checked = true;
        left.value = k;
        fire(left);
        const shows = get('l').src, empty = shows.startsWith('data:image/gif');
        check(size_of(get('truth').src) != '', 'the exact picture is none');
        check(empty || size_of(shows) == size_of(get('truth').src), what + ' of ' + left.options[k].text + ' is no picture');
        check(!empty || what == 'depth' || k == 0, 'no ' + what + ' of ' + left.options[k].text);
        check(get('says-l').textContent != '', 'nothing is said of ' + left.options[k].text);
      }
    const cuts = new Set();
    for (const at of [0, 25, 100]) {
      get('position').value = at;
      fire(get('position'));
      cuts.add(get('l').style.clipPath);
    }
    check(cuts.size == 3, 'the slider does not move');
  };

  addEventListener('load', () => {
    try {
      details();
      tables();
      theme();
      slider();
      check_widths(check);
      for (const text of document.querySelectorAll('.diagram text')) {
        const {width, height} = text.getBoundingClientRect(), size = text.hasAttribute('transform') ? width : height;  // turned upright
        check(size >= 9, `in a diagram “${text.textContent}” is ${size.toFixed(1)} high`);
      }
      for (const table of document.querySelectorAll('table.fits'))
        check(table.offsetWidth <= table.parentElement.clientWidth + 1, `a table is ${table.offsetWidth} wide, its place ${table.parentElement.clientWidth}`);
      check_contrast(check, document.documentElement.dataset.theme);
      document.getElementById('theme').click();
      check_contrast(check, document.documentElement.dataset.theme);
      check(![...document.querySelectorAll('[src],[href]')].some(e => /^(https?:)?\/\//.test(e.getAttribute('src') || e.getAttribute('href'))),
            'the page asks for something from elsewhere');
    } catch (e) {
      wrong.push('exception: ' + e);
    }
    parent.postMessage('PAGE ' + (wrong.length ? 'WRONG\n' + wrong.join('\n') : 'RIGHT') + '\n', '*');
  });
})();
