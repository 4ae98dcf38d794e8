// Light and dark, as the system has it or by the button; tables sorted by the buttons in their heads, each group of rows by itself.
const root = document.documentElement, themes = document.getElementById('theme');
const dark = matchMedia('(prefers-color-scheme: dark)');
let chosen = '';
function paint() {
  root.dataset.theme = chosen || (dark.matches ? 'dark' : 'light');
  themes.textContent = root.dataset.theme == 'dark' ? 'Light' : 'Dark';
}
themes.addEventListener('click', () => { chosen = root.dataset.theme == 'dark' ? 'light' : 'dark'; paint(); });
dark.addEventListener('change', paint);
paint();
for (const table of document.querySelectorAll('table'))
  table.querySelectorAll('thead th button').forEach((button, column) => button.addEventListener('click', () => {
    const head = button.parentElement, up = head.getAttribute('aria-sort') != 'ascending';
    for (const h of table.querySelectorAll('th')) h.removeAttribute('aria-sort');
    head.setAttribute('aria-sort', up ? 'ascending' : 'descending');
    const key = r => { const c = r.cells[column]; return 'v' in c.dataset ? +c.dataset.v : c.textContent; };
    for (const body of table.tBodies) {
      const rows = [...body.rows].filter(r => !r.classList.contains('group'));
      rows.sort((a, b) => {
        const x = key(a), y = key(b), d = typeof x == 'number' && typeof y == 'number' ? x - y : String(x).localeCompare(String(y));
        return up ? d : -d;
      });
      body.append(...rows);
    }
  }));
