// 3D viewer of a report: reads the scene that view/scene.cpp wrote into the page, draws it with three.js, and responds to the
// slider, the list of fields and the pointer. It fetches nothing and defines no global variables.
import {
  AmbientLight, Box3, BufferAttribute, BufferGeometry, Color, DataTexture, DirectionalLight, DoubleSide, LinearFilter,
  LineBasicMaterial, LineSegments, Mesh, MeshPhongMaterial, PerspectiveCamera, Scene, SRGBColorSpace, Vector3, WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const CREASE_COSINE = Math.cos(35 * Math.PI / 180);   // facets whose normals differ by less than 35 degrees are shaded smoothly
const FRAME_TIME_MS = 120;

const byId = (id) => document.getElementById(id);
const bytesOf = (base64) => Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
const uint16 = (base64) => new Uint16Array(bytesOf(base64).buffer);
const uint32 = (base64) => new Uint32Array(bytesOf(base64).buffer);
const float32 = (base64) => new Float32Array(bytesOf(base64).buffer);

function readScene() {
  const scene = JSON.parse(byId('scene').textContent);
  return {
    ...scene,
    positions: uint16(scene.positions), undeformed: uint16(scene.undeformed),
    base: uint32(scene.base), placement: bytesOf(scene.placement),
    triangles: uint32(scene.triangles), creases: uint32(scene.creases), palette: bytesOf(scene.palette),
    fields: scene.fields.map((field) => ({ ...field, values: uint16(field.values) })),
  };
}

// Coordinates of the bases, in mm, of one frame (or of the undeformed body).
function basePositions(scene, packed, first) {
  const out = new Float32Array(3 * scene.bases);
  for (let i = 0; i < out.length; ++i) {
    const axis = i % 3;
    out[i] = scene.low[axis] + (scene.high[axis] - scene.low[axis]) * packed[first + i] / 65535;
  }
  return out;
}

// Applies the placements: vertex = placement matrix times base.
function place(scene, bases, base, placement, out) {
  for (let v = 0; v < base.length; ++v) {
    const m = scene.placements[placement[v]], b = 3 * base[v];
    const x = bases[b], y = bases[b + 1], z = bases[b + 2];
    for (let i = 0; i < 3; ++i) out[3 * v + i] = m[3 * i] * x + m[3 * i + 1] * y + m[3 * i + 2] * z;
  }
  return out;
}

// Maps each vertex to the first coincident vertex (mirror images coincide at their plane).
function welded(positions, size) {
  const grid = 2e-5 * size, seen = new Map(), same = new Uint32Array(positions.length / 3);
  const cell = (x) => Math.round(x / grid) + 0x10000;   // 17 bits: three of them fit exactly into a double
  for (let v = 0; v < same.length; ++v) {
    const key = (cell(positions[3 * v]) * 0x20000 + cell(positions[3 * v + 1])) * 0x20000 + cell(positions[3 * v + 2]);
    if (!seen.has(key)) seen.set(key, v);
    same[v] = seen.get(key);
  }
  return same;
}

function facetNormals(triangles, positions) {
  const normals = new Float32Array(triangles.length), a = new Vector3(), b = new Vector3(), c = new Vector3();
  for (let t = 0; t < triangles.length; t += 3) {
    a.fromArray(positions, 3 * triangles[t]);
    b.fromArray(positions, 3 * triangles[t + 1]).sub(a);
    c.fromArray(positions, 3 * triangles[t + 2]).sub(a);
    b.cross(c).normalize().toArray(normals, t);
  }
  return normals;
}

// Groups the corners around a vertex that are shaded smoothly, by union-find over the edges that are not creases.
function smoothCorners(triangles, positions, size) {
  const same = welded(positions, size), normals = facetNormals(triangles, positions);
  const parent = Uint32Array.from(triangles.keys());
  const root = (i) => { while (parent[i] !== i) i = parent[i] = parent[parent[i]]; return i; };
  const edges = new Map(), vertices = positions.length / 3;
  for (let corner = 0; corner < triangles.length; ++corner) {
    const t = corner - corner % 3, next = t + (corner + 1) % 3;
    const p = same[triangles[corner]], q = same[triangles[next]];
    const key = Math.min(p, q) * vertices + Math.max(p, q), other = edges.get(key);
    if (other === undefined) { edges.set(key, corner); continue; }
    const s = other - other % 3;
    const cosine = normals[t] * normals[s] + normals[t + 1] * normals[s + 1] + normals[t + 2] * normals[s + 2];
    if (cosine < CREASE_COSINE) continue;
    for (const mine of [corner, next])
      for (const theirs of [other, s + (other + 1) % 3])
        if (same[triangles[mine]] === same[triangles[theirs]]) parent[root(mine)] = root(theirs);
  }
  return { parent, root };
}

// Duplicates vertices per smooth group, so that the vertex normals of three.js preserve the creases.
function buildSurface(scene) {
  const positions = place(scene, basePositions(scene, scene.undeformed, 0), scene.base, scene.placement,
    new Float32Array(3 * scene.base.length));
  const size = Math.max(...scene.window_high.map(Math.abs), ...scene.window_low.map(Math.abs), ...scene.high.map(Math.abs), ...scene.low.map(Math.abs));
  const { parent, root } = smoothCorners(scene.triangles, positions, size);
  const number = new Map(), index = new Uint32Array(scene.triangles.length), base = [], placement = [], at = [];
  for (let corner = 0; corner < parent.length; ++corner) {
    const group = root(corner);
    if (!number.has(group)) {
      number.set(group, base.length);
      at.push(scene.triangles[group]);
      base.push(scene.base[scene.triangles[group]]);
      placement.push(scene.placement[scene.triangles[group]]);
    }
    index[corner] = number.get(group);
  }
  return { index, base: Uint32Array.from(base), placement: Uint8Array.from(placement), at, undeformed: positions };
}

function paletteTexture(palette) {
  const count = palette.length / 3, data = new Uint8Array(4 * count).fill(255);
  for (let i = 0; i < count; ++i) data.set(palette.subarray(3 * i, 3 * i + 3), 4 * i);
  const texture = new DataTexture(data, count, 1);
  texture.colorSpace = SRGBColorSpace;
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

function paintColourBar(scene) {
  const colours = [];
  for (let i = 0; i < scene.palette.length; i += 3) colours.push(`rgb(${scene.palette.slice(i, i + 3).join(' ')})`);
  byId('colours').style.background = `linear-gradient(to right, ${colours.join(', ')})`;
}

function makeBody(scene) {
  const surface = buildSurface(scene), vertices = surface.base.length;
  const geometry = new BufferGeometry();
  geometry.setIndex(new BufferAttribute(surface.index, 1));
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(3 * vertices), 3));
  geometry.setAttribute('uv', new BufferAttribute(new Float32Array(2 * vertices).fill(0.5), 2));
  const material = new MeshPhongMaterial({
    map: paletteTexture(scene.palette), side: DoubleSide, shininess: 8, specular: 0x222222,
    polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
  });
  const surfaces = scene.mirrors.map((signs) => {
    const mesh = new Mesh(geometry, material);
    mesh.frustumCulled = false;   // otherwise the bounding sphere must be updated in every frame
    mesh.scale.set(...signs);
    return mesh;
  });

  const outline = new BufferGeometry();
  const points = new Float32Array(3 * scene.creases.length);
  scene.creases.forEach((v, i) => points.set(surface.undeformed.subarray(3 * v, 3 * v + 3), 3 * i));
  outline.setAttribute('position', new BufferAttribute(points, 3));
  const lines = scene.mirrors.map((signs) => {
    const line = new LineSegments(outline, new LineBasicMaterial({ color: 0x707070 }));
    line.scale.set(...signs);
    return line;
  });

  const obstacles = (scene.obstacles ?? []).flatMap((obstacle) => {
    const ends = new BufferGeometry();
    ends.setAttribute('position', new BufferAttribute(float32(obstacle.lines), 3));
    return scene.mirrors.map((signs) => {
      const line = new LineSegments(ends, new LineBasicMaterial({ color: 0x1a4da6, transparent: true, opacity: 0.55 }));
      line.scale.set(...signs);
      line.userData.shifts = obstacle.shifts.map((shift) => shift.map((x, axis) => x * signs[axis]));
      return line;
    });
  });

  // Vertices on a symmetry plane: the surface continues beyond it and is perpendicular to it, except facets in the plane (the cut).
  const size = surface.undeformed.reduce((most, x) => Math.max(most, Math.abs(x)), 0);
  const onPlane = [0, 1, 2].map((axis) => {
    const found = [];
    if (scene.mirrors.some((signs) => signs[axis] < 0))
      surface.at.forEach((v, i) => { if (Math.abs(surface.undeformed[3 * v + axis]) < 1e-4 * size) found.push(i); });
    return found;
  });
  function smoothAcrossPlanes() {
    const normals = geometry.attributes.normal, n = new Vector3();
    onPlane.forEach((list, axis) => {
      for (const i of list) {
        n.fromBufferAttribute(normals, i);
        if (Math.abs(n.getComponent(axis)) > 0.7) continue;
        n.setComponent(axis, 0).normalize();
        normals.setXYZ(i, n.x, n.y, n.z);
      }
    });
  }

  function show(frame, field) {
    const stride = 3 * scene.bases, count = scene.palette.length / 3;
    place(scene, basePositions(scene, scene.positions, frame * stride), surface.base, surface.placement, geometry.attributes.position.array);
    const uv = geometry.attributes.uv.array;
    for (let v = 0; v < vertices; ++v) {
      const share = field.values[frame * scene.bases + surface.base[v]] / 65535;
      uv[2 * v] = (0.5 + share * (count - 1)) / count;   // texel centres are the palette's entries
    }
    geometry.attributes.position.needsUpdate = geometry.attributes.uv.needsUpdate = true;
    geometry.computeVertexNormals();
    smoothAcrossPlanes();
    for (const line of obstacles) line.position.set(...line.userData.shifts[frame]);
    return new Box3().setFromBufferAttribute(geometry.attributes.position);
  }
  return { surfaces, lines, obstacles, show };
}

// Direction towards the eye, as for --view iso of the pictures.
function eyeDirection() {
  const azimuth = -35 * Math.PI / 180, elevation = 25 * Math.PI / 180;
  return new Vector3(Math.sin(azimuth) * Math.cos(elevation), Math.sin(elevation), Math.cos(azimuth) * Math.cos(elevation));
}

// The mirror image nearest to the eye, which hides the others; `part` is the bounding box of the modelled part.
function nearestImage(scene, part) {
  const centre = part.getCenter(new Vector3()), eye = eyeDirection();
  const depth = scene.mirrors.map((signs) => centre.clone().multiply(new Vector3(...signs)).dot(eye));
  return depth.indexOf(Math.max(...depth));
}

function number(value) {
  return Number(value.toPrecision(4)).toString();
}

function start() {
  const scene = readScene(), canvas = byId('body');
  const renderer = new WebGLRenderer({ canvas, antialias: true });
  const world = new Scene(), camera = new PerspectiveCamera(25, 1, 0.01, 1e5);
  world.background = new Color(0xffffff);
  const body = makeBody(scene);
  const light = new DirectionalLight(0xffffff, 1.6);
  light.position.set(-0.4, 0.6, 1);
  camera.add(light);
  world.add(...body.surfaces, ...body.lines, ...body.obstacles, camera, new AmbientLight(0xffffff, 1.6));

  const controls = new OrbitControls(camera, canvas);
  const render = () => renderer.render(world, camera);
  controls.addEventListener('change', render);

  const slider = byId('frame'), list = byId('field'), outline = byId('outline'), cut = byId('cut');
  const rows = [...document.querySelectorAll('#results tbody tr')];
  function show() {
    const frame = Number(slider.value), field = scene.fields[Number(list.value)];
    const box = body.show(frame, field), part = box.clone(), corner = new Vector3();
    const before_eye = cut.checked ? nearestImage(scene, part) : -1;
    scene.mirrors.forEach((signs, i) => {
      body.surfaces[i].visible = i !== before_eye;
      body.lines[i].visible = outline.checked && body.surfaces[i].visible;
      if (!body.surfaces[i].visible) return;
      for (const end of [part.min, part.max]) box.expandByPoint(corner.copy(end).multiply(body.surfaces[i].scale));
    });
    const size = box.getSize(new Vector3());
    byId('step').textContent = scene.frames[frame].label;
    byId('size').textContent = `drawn: ${number(size.x)} × ${number(size.y)} × ${number(size.z)} mm (x, y, z)`;
    byId('low').textContent = field.low_text;
    byId('high').textContent = field.high_text;
    byId('meaning').textContent = field.meaning;
    rows.forEach((row) => row.classList.toggle('shown', Number(row.dataset.step) === scene.frames[frame].step));
    render();
  }
  function resetView() {   // fits the whole motion; x to the right, y up
    const low = new Vector3(...scene.window_low), high = new Vector3(...scene.window_high);
    const centre = low.clone().add(high).multiplyScalar(0.5), half = high.clone().sub(centre), radius = half.length();
    const eye = eyeDirection(), right = new Vector3(0, 1, 0).cross(eye).normalize(), up = eye.clone().cross(right);
    const tangent = Math.tan(camera.fov * Math.PI / 360);
    let distance = 0;   // at which all corners of the window are visible
    for (let corner = 0; corner < 8; ++corner) {
      const c = new Vector3(...[0, 1, 2].map((i) => half.getComponent(i) * (corner >> i & 1 ? 1 : -1)));
      const wide = Math.max(Math.abs(c.dot(right)) / camera.aspect, Math.abs(c.dot(up))) / tangent;
      distance = Math.max(distance, c.dot(eye) + wide);
    }
    camera.position.copy(centre).addScaledVector(eye, 1.05 * distance);
    camera.near = radius / 100;
    camera.far = radius * 100;
    camera.updateProjectionMatrix();
    controls.target.copy(centre);
    controls.update();
  }
  function resize() {
    const width = canvas.clientWidth, height = canvas.clientHeight;
    renderer.setPixelRatio(window.devicePixelRatio);
    renderer.setSize(width, height, false);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    render();
  }

  let timer = 0;
  function play() {
    if (timer) { clearInterval(timer); timer = 0; byId('play').textContent = 'Play'; return; }
    byId('play').textContent = 'Stop';
    timer = setInterval(() => { slider.value = (Number(slider.value) + 1) % scene.frames.length; show(); }, FRAME_TIME_MS);
  }

  scene.fields.forEach((field, i) => list.add(new Option(field.unit ? `${field.label} (${field.unit})` : field.label, i)));
  slider.max = scene.frames.length - 1;
  slider.value = slider.max;
  paintColourBar(scene);
  slider.addEventListener('input', show);
  list.addEventListener('change', show);
  outline.addEventListener('change', show);
  cut.addEventListener('change', show);
  cut.checked = scene.mirrors.length > 1;
  cut.parentElement.hidden = !cut.checked;
  byId('play').addEventListener('click', play);
  byId('reset').addEventListener('click', () => { resetView(); render(); });
  new ResizeObserver(resize).observe(canvas);
  resize();
  resetView();
  show();
}

try {
  start();
} catch (problem) {
  byId('viewer-error').textContent = `The 3D view cannot be shown (${problem.message}); the rest of the page does not need it.`;
  byId('viewer-error').hidden = false;
}
