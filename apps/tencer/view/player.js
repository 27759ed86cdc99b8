// A slider through what is seen one after the other, and a switch that plays it.
import { byId, element } from './page.js';
import { draw, onEachFrame } from './world.js';

// In the toolbar, in the place called `name`. count() of them, of which number at() is seen; go(i)
// shows another, and label() says in words what it is. Gives a function to call when these change.
export function startPlayer({ name, title, perSecond, count, at, go, label }) {
  const place = byId(name);
  const slider = element('input');
  const said = element('span', undefined, 'said');
  const isPlayed = element('input');
  Object.assign(slider, { id: `${name}-number`, type: 'range', min: '0', step: '1' });
  said.id = `${name}-label`;
  Object.assign(isPlayed, { id: `${name}-play`, type: 'checkbox' });
  const labelled = (...parts) => {
    const result = element('label');
    result.append(...parts);
    return result;
  };
  place.append(labelled(`${title} `, slider), said, labelled(isPlayed, ' play'));

  let shownAt = null; // when the one that is seen was shown first
  onEachFrame((time) => {
    if (!isPlayed.checked || count() < 2) {
      shownAt = null;
      return false;
    }
    if (shownAt === null) shownAt = time;
    // The last one stays a while.
    const isLast = at() === count() - 1;
    if (time - shownAt > (isLast ? 1 : 0) + 1 / perSecond) {
      shownAt = time;
      go(isLast ? 0 : at() + 1);
    }
    return true;
  });
  slider.oninput = () => go(Number(slider.value));
  isPlayed.onchange = draw;
  return () => {
    place.hidden = count() < 2;
    if (place.hidden) return;
    slider.max = String(count() - 1);
    slider.value = String(at());
    slider.setAttribute('aria-valuetext', label());
    said.textContent = label();
  };
}
