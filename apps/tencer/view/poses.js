// Poses that the structure goes through while its cables are pulled: one at a time, or played.
import { bendCables } from './cables.js';
import { byId, change, onChange, page, seenDesign } from './page.js';
import { bendRods } from './rods.js';
import { draw, onEachFrame } from './world.js';

const perSecond = 8; // poses, when they are played

function showPose() {
  const { poses } = seenDesign();
  byId('poses').hidden = poses.length < 2;
  byId('pose').max = poses.length - 1;
  byId('pose').value = page.pose;
  byId('pose-label').textContent = poses.length ? poses[page.pose].label : '';
  if (!poses.length) return;
  const { shape } = poses[page.pose];
  bendRods(shape, 1);
  bendCables(shape, 1);
  draw();
}

let shownAt = null; // when the pose that is seen was shown first
function play(time) {
  const { poses } = seenDesign();
  const isPlayed = byId('play-poses').checked && poses.length > 1;
  if (!isPlayed) {
    shownAt = null;
    return false;
  }
  if (shownAt === null) shownAt = time;
  // The last one stays a while.
  const isLast = page.pose === poses.length - 1;
  if (time - shownAt > (isLast ? 1 : 1 / perSecond)) {
    shownAt = time;
    change({ pose: isLast ? 0 : page.pose + 1, mode: -1 });
  }
  return true;
}

export function startPoses() {
  byId('pose').oninput = (event) => change({ pose: Number(event.target.value), mode: -1 });
  byId('play-poses').onchange = draw;
  onChange(['design', 'pose', 'thick', 'colour'], showPose);
  onChange(['mode'], () => { if (page.mode >= 0) change({ pose: 0 }); });
  onEachFrame(play);
  showPose();
}
