// The designs of the page, each as its file has it with what is drawn of it beside (page_data.hpp).
const content = JSON.parse(document.getElementById('designs').textContent);

// x, y and z of one after the other.
const pointsOf = (numbers) => Array.from({ length: Math.floor(numbers.length / 3) },
  (_, i) => numbers.slice(3 * i, 3 * i + 3));

// Networks that the search went through, without the last where that is the design.
function stagesOf({ trace, cables, error }) {
  const all = (trace || []).flatMap(({ stage, snapshots }) => (snapshots || []).map((seen) => ({
    stage,
    max_percent: seen.max_percent,
    rods: seen.rods.map(pointsOf),
    cables: seen.cables.map((numbers) => {
      const [a, b] = pointsOf(numbers);
      return { a, b, tension: numbers[6] };
    }),
  })));
  const last = all[all.length - 1];
  const isDesign = last && error && last.cables.length === cables.length &&
    Math.abs(last.max_percent - error.max_percent) <= 1e-3 * error.max_percent;
  return isDesign ? all.slice(0, -1) : all;
}

function prepared({ file, drawn }, index) {
  return {
    ...file,
    index,
    axes: drawn.axes,
    closest: drawn.closest,
    crossings: drawn.crossings,
    modes: drawn.modes,
    shoves: drawn.shoves,
    poses: drawn.poses,
    stages: drawn.poses.length ? [] : stagesOf(file), // one thing to play
    check: file.check && file.check.lines ? file.check : undefined,
    anchors: file.anchors || [],
    pinned: file.pinned || [],
    point_loads: file.point_loads || [],
    line_loads: file.line_loads || [],
    rods: file.rods.map((rod, r) => ({ ...rod, ...drawn.rods[r] })),
  };
}

export const designs = content.designs.map(prepared);
export const firstDesign = content.first;

export const rodLength = (rod) => rod.rest_lengths.reduce((a, b) => a + b, 0);

// The diagonal of the target's box: errors are in percent of it.
export function sizeOf(design) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const rod of design.rods)
    for (const point of rod.target)
      point.forEach((x, axis) => {
        low[axis] = Math.min(low[axis], x);
        high[axis] = Math.max(high[axis], x);
      });
  return Math.hypot(...high.map((x, axis) => x - low[axis]));
}

// Where arc length s at rest is on the rod: an edge, and the part of it.
export function located(rod, s) {
  const lengths = rod.rest_lengths;
  let edge = 0;
  let rest = s;
  while (edge < lengths.length - 1 && rest > lengths[edge]) rest -= lengths[edge++];
  return { edge, t: Math.min(rest / lengths[edge], 1) };
}

// The point there; of the rod's pose, or of other points at its vertices.
export function pointAt(rod, s, points = rod.pose) {
  const { edge, t } = located(rod, s);
  const a = points[edge];
  const b = points[(edge + 1) % points.length];
  return a.map((x, axis) => (1 - t) * x + t * b[axis]);
}

export function endPoint(design, end) {
  return end.anchor !== undefined ? design.anchors[end.anchor] : pointAt(design.rods[end.rod], end.s);
}

// The anchors that cables end at.
export function usedAnchors(design) {
  const used = new Set(design.cables.flatMap((cable) => [cable.a.anchor, cable.b.anchor]));
  return design.anchors.filter((point, i) => used.has(i));
}

export function arcLengthAt(rod, vertex) {
  return rod.rest_lengths.slice(0, vertex).reduce((a, b) => a + b, 0);
}

const cablesBy = (design, pull) =>
  design.cables.map((cable, i) => i).sort((a, b) => pull(design.cables[a]) - pull(design.cables[b]));

// The cable that pulls least, -1: there are none.
export const leastTaut = (design) => cablesBy(design, (cable) => cable.tension)[0] ?? -1;

// What is said of some cables beside their numbers: those that decide how well it keeps its shape.
export function cableNotes(design, i) {
  const notes = [];
  if (design.cables.length > 1 && i === leastTaut(design)) notes.push('least taut');
  const forgives = design.check && design.check.forgives;
  if (forgives && forgives.first_slack === i) notes.push('goes slack first');
  if (forgives && forgives.decisive_cable === i) notes.push('its errors matter most');
  const holds = design.check && design.check.holds;
  if (holds && holds.cable === i) notes.push('nearest to breaking');
  return notes;
}
