// The gaps that a depth format eats: two sliders choose one of the pairs of planes that the library was asked about. Nothing is
// computed here but where things are drawn.
{
  const data = document.querySelector('script.gaps');
  if (data) {
    const {formats, rows} = JSON.parse(data.textContent), get = id => document.getElementById(id);
    const nears = [...new Set(rows.map(r => r.near))], fars = [...new Set(rows.map(r => r.far))];
    const text = x => x >= 1e9 ? '> 10⁹' : x < 1e-30 ? '≈ 0' : String(+x.toPrecision(3));
    const left = 54, right = 396, top = 12, bottom = 290, low = -9, high = 4;
    const y = gap => bottom - (bottom - top) * (Math.max(low, Math.min(high, Math.log10(gap))) - low) / (high - low);
    const slider = (id, values, unit) => {
      const range = get(id), says = get(id + '-says');
      range.max = values.length - 1;
      range.addEventListener('input', show);
      return () => {
        const value = values[+range.value];
        says.textContent = value;
        range.setAttribute('aria-valuetext', `${unit} at ${value}`);
        return value;
      };
    };
    const near_of = slider('gap-near', nears, 'near plane'), far_of = slider('gap-far', fars, 'far plane');
    get('gap-near').value = nears.indexOf(0.1);
    get('gap-far').value = fars.indexOf(1000);

    const pen = k => `fill="none" stroke="var(--gap${k})" stroke-width="2.5" stroke-dasharray="${['', '8 4', '2 3', '12 3 2 3', '5 5'][k % 5]}"`;
    get('gap-key').innerHTML = formats.map((name, k) =>
        `<li><svg width="44" height="12" aria-hidden="true"><line x1="2" x2="42" y1="6" y2="6" ${pen(k)}/></svg> ${name}</li>`).join('');

    function plot(row) {
      const x = z => left + (right - left) * Math.log10(z / row.near) / Math.log10(row.far / row.near);
      let html = '';
      for (let e = low; e <= high; e += 1)
        html += `<line x1="${left}" x2="${right}" y1="${y(10 ** e)}" y2="${y(10 ** e)}" stroke="var(--faint)"/>` +
            (e % 2 ? '' : `<text x="${left - 6}" y="${y(10 ** e) + 4}" font-size="12" text-anchor="end">${e < -3 ? '1e' + e : 10 ** e}</text>`);
      for (let e = Math.ceil(Math.log10(row.near) - 1e-9); e <= Math.log10(row.far) + 1e-9; ++e)
        html += `<line x1="${x(10 ** e)}" x2="${x(10 ** e)}" y1="${top}" y2="${bottom}" stroke="var(--faint)"/>` +
            `<text x="${x(10 ** e)}" y="${bottom + 16}" font-size="12" text-anchor="middle">${+(10 ** e).toPrecision(1)}</text>`;
      html += `<text x="${(left + right) / 2}" y="${bottom + 34}" font-size="12" text-anchor="middle">distance from the eye</text>`;
      formats.forEach((name, k) => {
        const line = row.at.map(p => x(p[0]).toFixed(1) + ',' + y(p[k + 1]).toFixed(1)).join(' ');
        html += `<polyline points="${line}" ${pen(k)}><title>${name}</title></polyline>`;
      });
      get('gap-plot').innerHTML = html;
    }

    function show() {
      const near = near_of(), far = far_of(), row = rows.find(r => r.near == near && r.far == far), table = get('gap-table');
      const last = row.at[row.at.length - 1];
      table.tHead.innerHTML = '<tr><th>distance</th>' + formats.map(f => `<th>${f}</th>`).join('') + '</tr>';
      table.tBodies[0].innerHTML = row.at.map(([z, ...gaps]) => `<tr><td>${text(z)}</td>` + gaps.map(g => `<td>${text(g)}</td>`).join('') + '</tr>').join('');
      get('gap-says').textContent = `With the near plane at ${near} and the far one at ${far}, two faces at distance ${text(last[0])} must be ${text(last[1])} apart for ` +
          `${formats[0]} to tell them apart, and ${text(last[2])} for ${formats[1]}.`;
      plot(row);
    }
    show();
  }
}
