// The 3D view of the design.
'use strict';
(() => {
  const { design, byId, element, rodInWords, anchorName, tension, description, rows } = page;
  const stage = byId('stage');
  let renderer;
  try {
    renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true });
  } catch (error) {
    document.body.className = 'flat';  // no WebGL: the drawn picture instead
    return;
  }

  const rodColours = [0x3f7cc4, 0x2fa37c, 0x8a68c8, 0x64859e, 0xb99338, 0xb7648c];
  const tensionColours = [0xf2a93b, 0xe4572e, 0xa80f4a].map((hex) => new THREE.Color(hex));
  const targetColour = 0x8b95a1;

  const vector = (p) => new THREE.Vector3(p[0], p[1], p[2]);
  const box = new THREE.Box3();
  design.rods.forEach((rod) => rod.pose.forEach((p) => box.expandByPoint(vector(p))));
  design.anchors.forEach((p) => box.expandByPoint(vector(p)));
  const centre = box.getCenter(new THREE.Vector3());
  const size = box.getSize(new THREE.Vector3()).length() || 1;

  const scene = new THREE.Scene();
  const camera = new THREE.PerspectiveCamera(32, 1, size / 100, size * 20);
  camera.up.set(0, 0, 1);
  const sky = new THREE.HemisphereLight(0xffffff, 0x667080, 0.85);
  sky.position.set(0, 0, 1);
  const lamp = new THREE.DirectionalLight(0xffffff, 0.45);
  camera.add(lamp);
  lamp.position.set(-0.4, 0.6, 1);
  scene.add(sky, camera);

  const add = (geometry, material) => {
    const mesh = new THREE.Mesh(geometry, material);
    scene.add(mesh);
    return mesh;
  };

  // The point of the pose at arc length s at rest.
  function attachment(end) {
    if (end.anchor !== undefined) return vector(design.anchors[end.anchor]);
    const { pose, rest_lengths: lengths } = design.rods[end.rod];
    let edge = 0;
    let s = end.s;
    while (edge < lengths.length - 1 && s > lengths[edge]) s -= lengths[edge++];
    const t = Math.min(s / lengths[edge], 1);
    return vector(pose[edge]).lerp(vector(pose[(edge + 1) % pose.length]), t);
  }

  // The chain of vertices as a curve whose parameter is the vertex number.
  class Chain extends THREE.Curve {
    constructor(points, closed) {
      super();
      this.points = points;
      this.closed = closed;
      this.edges = closed ? points.length : points.length - 1;
    }
    getPoint(t) {
      const at = Math.min(Math.max(t, 0), 1) * this.edges;
      const edge = Math.min(Math.floor(at), this.edges - 1);
      return this.points[edge].clone()
        .lerp(this.points[(edge + 1) % this.points.length], at - edge);
    }
    getPointAt(t) { return this.getPoint(t); }
    getTangentAt(t) {
      const n = this.points.length;
      const i = Math.round(t * this.edges);
      const wrap = (k) => this.closed ? (k + n) % n : Math.min(Math.max(k, 0), n - 1);
      return this.points[wrap(i + 1)].clone().sub(this.points[wrap(i - 1)]).normalize();
    }
  }

  const rodRadius = (rod) => Math.max(2 * Math.sqrt(Math.min(...rod.EI) / rod.EA), size / 160);

  function addRod(rod, index) {
    const points = rod.pose.map(vector);
    const chain = new Chain(points, rod.closed);
    const radius = rodRadius(rod);
    const material = new THREE.MeshStandardMaterial(
      { color: rodColours[index % rodColours.length], roughness: 0.55 });
    add(new THREE.TubeBufferGeometry(chain, chain.edges, radius, 14, rod.closed), material);
    if (!rod.closed)
      for (const end of [points[0], points[points.length - 1]])
        add(new THREE.SphereBufferGeometry(radius, 16, 12), material).position.copy(end);
    const start = add(new THREE.ConeBufferGeometry(radius * 2, radius * 5, 20), material);
    start.position.copy(points[0]);
    start.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), chain.getTangentAt(0));
  }

  function targetLine(rod) {
    const geometry = new THREE.BufferGeometry().setFromPoints(rod.target.map(vector));
    const material = new THREE.LineBasicMaterial(
      { color: targetColour, transparent: true, opacity: 0.8, depthTest: false });
    const line = rod.closed ? new THREE.LineLoop(geometry, material) : new THREE.Line(geometry, material);
    line.renderOrder = 1;
    scene.add(line);
    return line;
  }

  function cylinder(a, b, radius, material) {
    const mesh = add(new THREE.CylinderBufferGeometry(radius, radius, 1, 10, 1), material);
    const span = b.clone().sub(a);
    mesh.scale.y = span.length() || 1e-9;
    mesh.position.copy(a).addScaledVector(span, 0.5);
    mesh.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), span.normalize());
    return mesh;
  }

  const tensions = design.cables.map((cable) => cable.tension);
  const low = Math.min(...tensions, Infinity);
  const high = Math.max(...tensions, -Infinity);
  function tensionColour(value) {
    const at = high > low ? (value - low) / (high - low) * (tensionColours.length - 1) : 1;
    const first = Math.min(Math.floor(at), tensionColours.length - 2);
    return tensionColours[first].clone().lerp(tensionColours[first + 1], at - first);
  }
  if (design.cables.length) {
    const title = element('div', `tension, ${design.force_unit}`, 'soft');
    const bar = element('div', undefined, 'bar');
    const stops = tensionColours.map((colour) => colour.getStyle()).join(', ');
    bar.style.background = `linear-gradient(to right, ${stops})`;
    const ends = element('div', undefined, 'ends');
    ends.append(element('span', tension(low)), element('span', tension(high)));
    byId('scale').append(title, bar, ends);
  }

  design.rods.forEach(addRod);
  const targets = design.rods.map(targetLine);
  const anchorMaterial = new THREE.MeshStandardMaterial({ color: 0x6b7682, roughness: 0.8 });
  design.anchors.forEach((p) => {
    add(new THREE.BoxBufferGeometry(size / 60, size / 60, size / 60), anchorMaterial)
      .position.copy(vector(p));
  });
  const unseen = new THREE.MeshBasicMaterial({ visible: false });
  const cables = design.cables.map((cable, i) => {
    const a = attachment(cable.a);
    const b = attachment(cable.b);
    const material = new THREE.MeshBasicMaterial({ color: tensionColour(cable.tension) });
    const shown = cylinder(a, b, size / 520, material);
    const picked = cylinder(a, b, size / 90, unseen);  // wide enough to hit with a pointer
    picked.userData.cable = i;
    return { shown, picked, middle: a.lerp(b, 0.5) };
  });

  const labels = [];
  function label(text, at, className) {
    const span = element('span', text, className);
    byId('labels').append(span);
    labels.push({ span, at });
    return span;
  }
  const cableLabels = cables.map((cable, i) => label(String(i + 1), cable.middle, ''));
  design.anchors.forEach((p, i) => label(anchorName(i), vector(p), 'anchor'));
  if (design.rods.length > 1)
    design.rods.forEach((rod, i) => label(rodInWords(i), vector(rod.pose[0]), 'rod'));

  const direction = new THREE.Vector3(0.3, -0.75, 0.85).normalize();
  function fit(width, height) {
    const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => new THREE.Vector3(
      i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z));
    const rotation = new THREE.Matrix4().lookAt(direction, new THREE.Vector3(), camera.up);
    const inverse = new THREE.Matrix4().getInverse(rotation);
    const slope = Math.tan(camera.fov * Math.PI / 360);
    const distance = Math.max(...corners.map((corner) => {
      const p = corner.sub(centre).applyMatrix4(inverse);
      return p.z + Math.max(Math.abs(p.y), Math.abs(p.x) * height / width) / slope;
    }));
    camera.position.copy(centre).addScaledVector(direction, Math.max(distance, size / 2) * 1.04);
  }

  const canvas = renderer.domElement;
  stage.prepend(canvas);
  const controls = new THREE.OrbitControls(camera, canvas);
  controls.target.copy(centre);

  let pending = false;
  function draw() {
    if (pending) return;
    pending = true;
    requestAnimationFrame(() => {
      pending = false;
      renderer.render(scene, camera);
      const { clientWidth: width, clientHeight: height } = canvas;
      for (const { span, at } of labels) {
        const p = at.clone().project(camera);
        span.style.display = Math.abs(p.z) < 1 ? '' : 'none';
        span.style.transform = `translate(${(p.x + 1) / 2 * width}px, ${(1 - p.y) / 2 * height}px)` +
          ' translate(-50%, -50%)';
      }
    });
  }

  let hovered = -1;
  let kept = -1;
  function choose() {
    const chosen = hovered >= 0 ? hovered : kept;
    cables.forEach((cable, i) => {
      const faded = chosen >= 0 && i !== chosen;
      cable.shown.scale.x = cable.shown.scale.z = i === chosen ? 2.2 : 1;
      cable.shown.material.transparent = faded;
      cable.shown.material.opacity = faded ? 0.35 : 1;
      cable.shown.material.needsUpdate = true;
      cableLabels[i].className = rows[i].className = i === chosen ? 'chosen' : '';
    });
    draw();
  }

  const ray = new THREE.Raycaster();
  const pickable = cables.map((cable) => cable.picked);
  function cableAt(event) {
    const frame = canvas.getBoundingClientRect();
    ray.setFromCamera({ x: (event.clientX - frame.left) / frame.width * 2 - 1,
      y: 1 - (event.clientY - frame.top) / frame.height * 2 }, camera);
    const hits = ray.intersectObjects(pickable);
    return hits.length ? hits[0].object.userData.cable : -1;
  }

  const tip = byId('tip');
  function showTip(event) {
    if (hovered < 0) return tip.style.display = 'none';
    const lines = description(hovered);
    tip.replaceChildren(element('b', lines[0]), ...lines.slice(1).map((line) => element('div', line)));
    tip.style.display = 'block';
    const frame = stage.getBoundingClientRect();
    const left = Math.min(event.clientX - frame.left + 16, frame.width - tip.offsetWidth - 8);
    const top = Math.min(event.clientY - frame.top + 16, frame.height - tip.offsetHeight - 8);
    tip.style.left = `${left}px`;
    tip.style.top = `${top}px`;
  }
  canvas.addEventListener('pointermove', (event) => {
    const before = hovered;
    hovered = event.buttons ? -1 : cableAt(event);
    canvas.style.cursor = hovered >= 0 ? 'pointer' : 'grab';
    if (hovered !== before) choose();
    showTip(event);
  });
  canvas.addEventListener('pointerleave', (event) => { hovered = -1; choose(); showTip(event); });
  let pressed = null;  // a drag is not a click
  canvas.addEventListener('pointerdown', (event) => { pressed = [event.clientX, event.clientY]; });
  canvas.addEventListener('pointerup', (event) => {
    if (!pressed || Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 4) return;
    hovered = kept = cableAt(event);
    choose();
    showTip(event);
    if (kept >= 0) rows[kept].scrollIntoView({ block: 'nearest', behavior: 'smooth' });
  });
  rows.forEach((row, i) => row.addEventListener('click', () => {
    kept = kept === i ? -1 : i;
    choose();
  }));

  byId('show-target').onchange = (event) => {
    targets.forEach((line) => { line.visible = event.target.checked; });
    draw();
  };
  byId('show-labels').onchange = (event) => {
    byId('labels').style.display = event.target.checked ? '' : 'none';
  };

  let fitted = false;
  function resize() {
    const { clientWidth: width, clientHeight: height } = stage;
    if (!width || !height) return;
    renderer.setPixelRatio(window.devicePixelRatio);
    renderer.setSize(width, height);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    if (!fitted) {
      fit(width, height);
      controls.update();
      fitted = true;
    }
    draw();
  }
  new ResizeObserver(resize).observe(stage);
  controls.addEventListener('change', draw);
  resize();
})();
