// Poses that the structure goes through while its cables are pulled: one at a time, or played.
import { bendCables } from './cables.js';
import { change, onChange, page, seenDesign } from './page.js';
import { startPlayer } from './player.js';
import { bendRods } from './rods.js';
import { draw } from './world.js';

function showPose() {
  const { poses } = seenDesign();
  if (!poses.length) return;
  const { shape } = poses[page.pose];
  bendRods(shape, 1);
  bendCables(shape, 1);
  draw();
}

export function startPoses() {
  const showSlider = startPlayer({
    name: 'poses', title: 'pose', perSecond: 8,
    count: () => seenDesign().poses.length,
    at: () => page.pose,
    go: (pose) => change({ pose, mode: -1 }),
    label: () => seenDesign().poses[page.pose].label,
  });
  onChange(['design', 'pose'], showSlider);
  onChange(['design', 'pose', 'thick', 'colour'], showPose);
  onChange(['mode'], () => { if (page.mode >= 0) change({ pose: 0 }); });
  showSlider();
  showPose();
}
