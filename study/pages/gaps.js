// The table of gaps in the lesson: two sliders choose one of the pairs of planes that the library was asked about.
{
  const data = document.querySelector('script.gaps');
  if (data) {
    const {formats, rows} = JSON.parse(data.textContent), get = id => document.getElementById(id);
    const nears = [...new Set(rows.map(r => r.near))], fars = [...new Set(rows.map(r => r.far))];
    const text = x => x >= 1e9 ? '> 10⁹' : String(+x.toPrecision(3));
    const show = () => {
      const near = nears[+get('gap-near').value], far = fars[+get('gap-far').value];
      get('gap-near-says').textContent = near;
      get('gap-far-says').textContent = far;
      const row = rows.find(r => r.near == near && r.far == far), table = get('gap-table');
      table.tHead.innerHTML = '<tr><th>distance</th>' + formats.map(f => `<th>${f}</th>`).join('') + '</tr>';
      table.tBodies[0].innerHTML = row.at.map(([z, ...gaps]) => `<tr><td>${text(z)}</td>` + gaps.map(g => `<td>${text(g)}</td>`).join('') + '</tr>').join('');
    };
    get('gap-near').addEventListener('input', show);
    get('gap-far').addEventListener('input', show);
    show();
  }
}
