// No two names of a picture, a tree or a diagram of intervals lie over one another, and none is missing.
const check_labels = (check, player, where) => {
  const box_of = text => {  // of its letters: lines of text are higher
    const {left, right, top, bottom, height} = text.getBoundingClientRect();
    return {text: text.textContent, left, right, top: top + height * 0.18, bottom: bottom - height * 0.18};
  };
  for (const svg of player.root.querySelectorAll('svg')) {
    const boxes = [...svg.querySelectorAll('text')].filter(text => !text.closest('.cells')).map(box_of).sort((a, b) => a.left - b.left);
    boxes.forEach((a, k) => {
      for (const b of boxes.slice(k + 1)) {
        if (b.left > a.right - 0.5) break;
        check(Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) < 0.5, `${where}: the name ${a.text} lies over ${b.text}`);
      }
    });
  }
  const {pieces, painted} = player.state, {faces, samples} = player.scene;
  const count = player.root.querySelectorAll('.picture text.halo:not(.vertex)').length;
  const names = pieces.size || samples ? pieces.size : faces.filter(f => f.rings.length).length;
  const least = names > 26 ? 0.9 * names : names;  // of many there may be one without room
  check(count <= names && (painted.length || count >= least), `${where}: ${count} names of ${names} faces are shown`);
  const vertices = new Set(player.scene.edges.flatMap(edge => edge.name.split('–')));
  const numbers = [...player.root.querySelectorAll('.picture text.vertex')].map(text => text.textContent);
  check(numbers.every(v => vertices.has(v)) && (player.scene.edges.length > 100 || numbers.length >= 0.9 * vertices.size),
        `${where}: ${numbers.length} numbers of ${vertices.size} vertices are shown`);
};

// What stands in a sample is within it.
const check_cells = (check, player, where) => {
  for (const group of player.root.querySelectorAll('.picture .cells g')) {
    const text = group.querySelector('text').getBoundingClientRect(), cell = group.querySelector('rect').getBoundingClientRect();
    check(text.width == 0 || text.left > cell.left - 0.5 && text.right < cell.right + 0.5, `${where}: ${group.querySelector('text').textContent} is wider than its sample`);
  }
};
