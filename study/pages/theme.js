// Light and dark: as the system has it, or by the button.
const root = document.documentElement;
{
  const button = document.getElementById('theme'), dark = matchMedia('(prefers-color-scheme: dark)');
  let chosen = '';
  const paint = () => {
    root.dataset.theme = chosen || (dark.matches ? 'dark' : 'light');
    button.textContent = root.dataset.theme == 'dark' ? 'Light' : 'Dark';
  };
  button.addEventListener('click', () => { chosen = root.dataset.theme == 'dark' ? 'light' : 'dark'; paint(); });
  dark.addEventListener('change', paint);
  paint();
}
// On paper nothing can be unfolded.
addEventListener('beforeprint', () => {
  for (const details of document.querySelectorAll('details')) details.open = true;
});
