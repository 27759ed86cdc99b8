// Tubes and strips: the outline of a section carried along a smooth curve through a rod's vertices.
import { vector } from './world.js';

// Each entry: its place across, (u, v), and the outline's normal there. Between entries k and the
// next one there is a face where `faces` says so.
export function roundProfile(radius) {
  const count = 14;
  const entries = [];
  for (let k = 0; k < count; ++k) {
    const angle = 2 * Math.PI * k / count;
    const [nu, nv] = [Math.cos(angle), Math.sin(angle)];
    entries.push({ u: radius * nu, v: radius * nv, nu, nv });
  }
  return { entries, faces: entries.map((entry, k) => [k, (k + 1) % count]), round: true };
}

// Its half sizes along the normal and the binormal.
export function flatProfile(u, v) {
  const side = (nu, nv) => [-1, 1].map((s) =>
    ({ u: u * (nu || -s * nv), v: v * (nv || s * nu), nu, nv }));
  const entries = [side(1, 0), side(0, 1), side(-1, 0), side(0, -1)].flat();
  return { entries, faces: [[0, 1], [2, 3], [4, 5], [6, 7]], round: false };
}

// So many pieces of an edge that all rods together look smooth and stay quick to draw.
export function smoothness(rods) {
  const edges = rods.reduce((sum, rod) => sum + rod.rest_lengths.length, 0);
  return Math.max(1, Math.min(8, Math.floor(2500 / edges)));
}

// Points of the smooth curve through the vertices; a closed one does not repeat its first.
export function smoothCurve(points, closed, pieces) {
  const curve = new THREE.CatmullRomCurve3(points.map(vector), closed, 'centripetal');
  const edges = closed ? points.length : points.length - 1;
  const count = edges * pieces + (closed ? 0 : 1);
  return Array.from({ length: count }, (_, i) => curve.getPoint(i / (edges * pieces)));
}

// A value a vertex, at the points of smoothCurve.
export function alongCurve(values, closed, pieces) {
  const edges = closed ? values.length : values.length - 1;
  const count = edges * pieces + (closed ? 0 : 1);
  return Array.from({ length: count }, (_, i) => {
    const vertex = Math.floor(i / pieces);
    const t = i / pieces - vertex;
    return (1 - t) * values[vertex] + (t > 0 ? t * values[(vertex + 1) % values.length] : 0);
  });
}

function tangentsOf(points, closed) {
  const n = points.length;
  const wrap = (k) => closed ? (k + n) % n : Math.min(Math.max(k, 0), n - 1);
  return points.map((p, i) => points[wrap(i + 1)].clone().sub(points[wrap(i - 1)]).normalize());
}

// Normals carried along without twist; a closed curve spreads what is missing at its end.
function carriedNormals(tangents, closed) {
  const start = new THREE.Vector3(0, 0, 1);
  if (Math.abs(tangents[0].z) > 0.9) start.set(1, 0, 0);
  let normal = start.cross(tangents[0]).normalize();
  const normals = [normal];
  const turn = new THREE.Quaternion();
  for (let i = 1; i < tangents.length; ++i) {
    turn.setFromUnitVectors(tangents[i - 1], tangents[i]);
    normal = normal.clone().applyQuaternion(turn);
    normals.push(normal);
  }
  if (!closed) return normals;
  turn.setFromUnitVectors(tangents[tangents.length - 1], tangents[0]);
  const arrived = normal.clone().applyQuaternion(turn);
  const angle = Math.atan2(arrived.clone().cross(normals[0]).dot(tangents[0]),
    arrived.dot(normals[0]));
  return normals.map((one, i) => one.applyAxisAngle(tangents[i], angle * i / normals.length));
}

// Directors, one an edge, at the points of smoothCurve: turned evenly from the middle of one edge
// to that of the next.
export function directorsAlong(directors, closed, pieces) {
  const edges = directors.length;
  const count = edges * pieces + (closed ? 0 : 1);
  const wrap = (e) => closed ? (e + edges) % edges : Math.min(Math.max(e, 0), edges - 1);
  return Array.from({ length: count }, (_, i) => {
    const at = i / pieces - 0.5;
    const e = Math.floor(at);
    return vector(directors[wrap(e)]).lerp(vector(directors[wrap(e + 1)]), at - e);
  });
}

// A mesh's geometry that can be laid along other points of the same number.
export class Sweep {
  constructor(points, closed, profile, directors) {
    Object.assign(this, { closed, profile, directors, count: points.length });
    const { entries, faces } = profile;
    const vertices = (points.length + (closed ? 0 : 2)) * entries.length;
    this.geometry = new THREE.BufferGeometry();
    for (const name of ['position', 'normal', 'color'])
      this.geometry.setAttribute(name,
        new THREE.BufferAttribute(new Float32Array(3 * vertices), 3));
    const index = [];
    const n = entries.length;
    for (let i = 0; i < points.length - (closed ? 0 : 1); ++i)
      for (const [a, b] of faces) {
        const next = (i + 1) % points.length;
        index.push(i * n + a, i * n + b, next * n + a, i * n + b, next * n + b, next * n + a);
      }
    if (!closed)
      for (const [cap, flip] of [[points.length, true], [points.length + 1, false]])
        for (let k = 1; k < n - 1; ++k)
          index.push(cap * n, cap * n + (flip ? k + 1 : k), cap * n + (flip ? k : k + 1));
    this.geometry.setIndex(index);
    this.lay(points);
  }

  lay(points) {
    const tangents = tangentsOf(points, this.closed);
    const normals = this.directors || carriedNormals(tangents, this.closed);
    const position = this.geometry.attributes.position;
    const normal = this.geometry.attributes.normal;
    const put = (ring, i, end) => this.profile.entries.forEach(({ u, v, nu, nv }, k) => {
      const tangent = tangents[i];
      const across = normals[i].clone().addScaledVector(tangent, -normals[i].dot(tangent)).normalize();
      const beside = tangent.clone().cross(across);
      const at = ring * this.profile.entries.length + k;
      position.setXYZ(at, points[i].x + u * across.x + v * beside.x,
        points[i].y + u * across.y + v * beside.y, points[i].z + u * across.z + v * beside.z);
      if (end) normal.setXYZ(at, end * tangent.x, end * tangent.y, end * tangent.z);
      else normal.setXYZ(at, nu * across.x + nv * beside.x, nu * across.y + nv * beside.y,
        nu * across.z + nv * beside.z);
    });
    points.forEach((p, i) => put(i, i, 0));
    if (!this.closed) {
      put(points.length, 0, -1);
      put(points.length + 1, points.length - 1, 1);
    }
    position.needsUpdate = normal.needsUpdate = true;
    this.geometry.computeBoundingSphere();
  }

  // A colour for each point.
  paint(colours) {
    const n = this.profile.entries.length;
    const color = this.geometry.attributes.color;
    const put = (ring, { r, g, b }) => {
      for (let k = 0; k < n; ++k) color.setXYZ(ring * n + k, r, g, b);
    };
    colours.forEach((colour, i) => put(i, colour));
    if (!this.closed) {
      put(colours.length, colours[0]);
      put(colours.length + 1, colours[colours.length - 1]);
    }
    color.needsUpdate = true;
  }
}
