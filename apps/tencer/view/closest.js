// Where strands, cables and marks come nearest to each other, and where rods cross.
import { pointAt, sizeOf } from './data.js';
import { markedIndex, onChange, seenDesign } from './page.js';
import { cableInWords, placeInWords } from './words.js';
import { showGroup, vector } from './world.js';

const nearColour = 0xff5a1f;

export function pairInWords(design, pair) {
  return [...pair.cables.map(cableInWords),
    ...pair.places.map((place) => placeInWords(design, place.rod, place.s))].join(' and ');
}

// Of what is chosen, or under the pointer.
function markedPlaces(design) {
  const pair = design.closest[markedIndex('closest')];
  if (pair) return pair.places;
  const crossing = design.crossings[markedIndex('crossing')];
  return crossing ? [crossing.over, crossing.under] : [];
}

function showClosest() {
  const design = seenDesign();
  const places = markedPlaces(design);
  const size = sizeOf(design);
  const points = places.map((place) => vector(pointAt(design.rods[place.rod], place.s)));
  const balls = points.map((point) => {
    const ball = new THREE.Mesh(new THREE.SphereBufferGeometry(size / 70, 20, 14),
      new THREE.MeshBasicMaterial({ color: nearColour, transparent: true, opacity: 0.75,
        depthTest: false }));
    ball.position.copy(point);
    ball.renderOrder = 2;
    return ball;
  });
  const line = new THREE.LineSegments(new THREE.BufferGeometry().setFromPoints(points),
    new THREE.LineBasicMaterial({ color: nearColour, depthTest: false }));
  line.renderOrder = 2;
  showGroup('closest', points.length === 2 ? [...balls, line] : balls);
}

export function startClosest() { onChange(['design', 'chosen', 'hovered'], showClosest); }
