// The scene in three dimensions: cuboids, planes, arrows, trails. Knows nothing of time; replay.js and live.js tell it
// where things are. World axes of rigor are those of three.js (y up).
import {AmbientLight, BufferAttribute, BufferGeometry, BoxGeometry, CanvasTexture, Color, ConeGeometry, CylinderGeometry, DirectionalLight, DynamicDrawUsage,
        FrontSide, Group, HemisphereLight, InstancedMesh, LineBasicMaterial, LineSegments, Matrix4, Mesh, MeshBasicMaterial, MeshLambertMaterial, PerspectiveCamera,
        Quaternion, Raycaster, RepeatWrapping, Scene, Sprite, SpriteMaterial, SRGBColorSpace, Vector2, Vector3, WebGLRenderer} from 'three';
import {OrbitControls} from 'three/examples/jsm/controls/OrbitControls.js';
import {mergeGeometries} from 'three/examples/jsm/utils/BufferGeometryUtils.js';

const css = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const ghosts = ['#e6007a', '#00938f', '#7a5cff', '#b06a00', '#5b8a00', '#c0392b', '#2f7fd6'];
/// The colour of a further run (1, 2, ...): of its cuboids, which are see-through, and of its curves.
export const ghost_color = index => ghosts[(index - 1) % ghosts.length];
const palette = ['#4e8fd0', '#e08a3c', '#58a866', '#a678c8', '#c9b04a', '#4bb0b0', '#d0708f', '#8f8f98', '#7a9a3a', '#b5654a'];
const up = new Vector3(0, 1, 0);

function drawn(size, paint) {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = size;
  paint(canvas.getContext('2d'), size);
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  texture.anisotropy = 8;
  return texture;
}
const edged = () => drawn(128, (g, n) => {
  g.fillStyle = '#fff', g.fillRect(0, 0, n, n);
  g.strokeStyle = '#555', g.lineWidth = 4, g.strokeRect(1, 1, n - 2, n - 2);
});
// A pane in a frame. Frames of later runs are thinner, so that where cuboids coincide each shows beside the others.
const framed = index => drawn(128, (g, n) => {
  g.fillStyle = '#ffffff4d', g.fillRect(0, 0, n, n);
  g.strokeStyle = '#fff', g.lineWidth = 30 / (1 + index), g.strokeRect(0, 0, n, n);
});
function arrow_shape() {
  const shaft = new CylinderGeometry(0.025, 0.025, 0.75, 8).translate(0, 0.375, 0), head = new ConeGeometry(0.07, 0.25, 12).translate(0, 0.875, 0);
  return mergeGeometries([shaft, head]);
}

/// A set of arrows in one colour, drawn in one call.
class Arrows {
  constructor(parent, color, most, thickness = 1, over = false) {
    this.mesh = new InstancedMesh(arrow_shape(), new MeshBasicMaterial({color, depthTest: !over, transparent: over}), most);
    this.mesh.frustumCulled = false;
    this.thickness = thickness;
    this.most = most;
    this.clear();
    parent.add(this.mesh);
  }
  clear() { this.mesh.count = 0; this.mesh.instanceMatrix.needsUpdate = true; }
  add(from, vector, length) {
    if (this.mesh.count >= this.most || !(length > 1e-6)) return;
    turn.setFromUnitVectors(up, axis.copy(vector).normalize());
    place.compose(from, turn, size.set(this.thickness, length, this.thickness));
    this.mesh.setMatrixAt(this.mesh.count++, place);
    this.mesh.instanceMatrix.needsUpdate = true;
  }
}
const turn = new Quaternion(), place = new Matrix4(), size = new Vector3(), axis = new Vector3(), here = new Vector3();

/// The cuboids of one run, with their trails and arrows.
export class Crowd {
  constructor(stage, bodies, index, scale) {
    this.bodies = bodies, this.stage = stage, this.group = new Group();
    const ghost = index > 0;
    this.mesh = new InstancedMesh(new BoxGeometry(1, 1, 1), new MeshLambertMaterial({map: ghost ? framed(index) : edged(), transparent: ghost, depthWrite: !ghost,
      polygonOffset: ghost, polygonOffsetFactor: -2 * index, polygonOffsetUnits: -2 * index})  // over what it shares a face with
    , bodies.length);
    this.mesh.instanceMatrix.setUsage(DynamicDrawUsage);
    this.mesh.frustumCulled = false;
    bodies.forEach((_, i) => this.mesh.setColorAt(i, new Color(ghost ? ghost_color(index) : palette[i % palette.length])));
    this.group.add(this.mesh);
    const few = Math.min(bodies.length, 200);
    this.axes = ['#d0342c', '#2e9e44', '#2f62d9'].map(color => new Arrows(this.group, color, few, scale));
    this.velocities = new Arrows(this.group, ghost ? ghost_color(index) : '#1f9fb0', 2000, scale);
    this.impulses = new Arrows(this.group, ghost ? ghost_color(index) : '#e3472b', 2000, 1.3 * scale, true);  // over the cuboid into which it points
    this.trail = new LineSegments(new BufferGeometry(), new LineBasicMaterial({color: ghost ? ghost_color(index) : css('--soft')}));
    this.trail.frustumCulled = false;
    this.group.add(this.trail);
    stage.scene.add(this.group);
  }
  leave() {
    this.stage.scene.remove(this.group);
    this.group.traverse(part => { part.geometry?.dispose(), part.material?.map?.dispose(), part.material?.dispose(); });
  }
  /// p: 3, q: 4 (w x y z) numbers for each body
  place(p, q, show_axes) {
    this.axes.forEach(a => a.clear());
    for (let i = 0; i < this.bodies.length; ++i) {
      const s = this.bodies[i].size;
      here.fromArray(p, 3 * i);
      turn.set(q[4 * i + 1], q[4 * i + 2], q[4 * i + 3], q[4 * i]).normalize();
      place.compose(here, turn, size.set(s[0], s[1], s[2]));
      this.mesh.setMatrixAt(i, place);
      if (show_axes && i < 200) {
        const mine = turn.clone(), at = here.clone();
        this.axes.forEach((arrows, k) => {
          const v = new Vector3().setComponent(k, 1).applyQuaternion(mine);
          arrows.add(at, v, s[k] / 2 + 0.35 * Math.min(...s));
        });
      }
    }
    this.mesh.instanceMatrix.needsUpdate = true;
    this.mesh.boundingSphere = null;
  }
  /// points: pairs of ends, 6 numbers a piece
  trace(points) {
    const geometry = this.trail.geometry, have = geometry.getAttribute('position');
    if (!have || have.array.length < points.length) geometry.setAttribute('position', new BufferAttribute(new Float32Array(2 * points.length + 6), 3).setUsage(DynamicDrawUsage));
    const position = geometry.getAttribute('position');
    position.array.set(points);
    position.needsUpdate = true;
    geometry.setDrawRange(0, points.length / 3);
  }
}

// A convex polygon, cut where it lies behind a plane.
function cut(polygon, point, normal) {
  const kept = [], height = v => v.clone().sub(point).dot(normal);
  polygon.forEach((a, i) => {
    const b = polygon[(i + 1) % polygon.length], ha = height(a), hb = height(b);
    if (ha >= 0) kept.push(a);
    if ((ha < 0) !== (hb < 0) && Math.abs(ha - hb) > 1e-12) kept.push(a.clone().lerp(b, ha / (ha - hb)));
  });
  return kept;
}

export class Stage {
  /// middle, reach: where the bodies are in the course of the run; view_reach: how much of it the camera takes in
  constructor(canvas, planes, middle, reach, view_reach = reach) {
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({canvas, antialias: true, preserveDrawingBuffer: true});
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.scene = new Scene();
    this.scene.background = new Color(css('--sky'));
    this.scene.add(new HemisphereLight('#ffffff', '#8899aa', 1.6), new AmbientLight('#ffffff', 0.5));
    const sun = new DirectionalLight('#ffffff', 1.7);
    sun.position.set(0.6, 1, 0.8);
    this.scene.add(sun);
    this.camera = new PerspectiveCamera(40, 1, view_reach / 200, reach * 60);
    this.camera.position.copy(middle).add(new Vector3(0.75, 0.55, 1).normalize().multiplyScalar(view_reach * 2.6));
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.target.copy(middle);
    this.controls.update();
    this.world = new Group();
    const length = view_reach * 0.25;
    [['x', '#d0342c'], ['y', '#2e9e44'], ['z', '#2f62d9']].forEach(([letter, color], k) => {
      const v = new Vector3().setComponent(k, 1);
      new Arrows(this.world, color, 1, length, true).add(new Vector3(), v, length);
      const label = new Sprite(new SpriteMaterial({map: drawn(64, (g, n) => { g.fillStyle = color, g.font = 'bold 48px sans-serif', g.textAlign = 'center', g.fillText(letter, n / 2, 48); }), depthTest: false}));
      label.position.copy(v).multiplyScalar(length * 1.15);
      label.scale.setScalar(length * 0.28);
      this.world.add(label);
    });
    this.scene.add(this.world);
    this.lay(planes, middle, reach);
    new ResizeObserver(() => this.fit()).observe(canvas.parentElement);
    this.fit();
  }
  lay(planes, middle, reach) {
    const grid = drawn(256, (g, n) => {
      g.fillStyle = css('--floor'), g.fillRect(0, 0, n, n);
      g.strokeStyle = css('--grid'), g.lineWidth = 4, g.strokeRect(0, 0, n, n);
    });
    grid.wrapS = grid.wrapT = RepeatWrapping;
    for (const plane of planes) {
      const n = new Vector3(...plane.normal), point = new Vector3(...plane.point), centre = middle.clone().addScaledVector(n, point.clone().sub(middle).dot(n));
      const a = new Vector3(Math.abs(n.x) < 0.9 ? 1 : 0, Math.abs(n.x) < 0.9 ? 0 : 1, 0).cross(n).normalize(), b = n.clone().cross(a), half = 3 * Math.max(reach, 1);
      let polygon = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([u, v]) => centre.clone().addScaledVector(a, u * half).addScaledVector(b, v * half));
      for (const other of planes)
        if (other !== plane) polygon = cut(polygon, new Vector3(...other.point), new Vector3(...other.normal));
      if (polygon.length < 3) continue;
      const geometry = new BufferGeometry(), at = [], uv = [], index = [];
      polygon.forEach((v, i) => {
        at.push(v.x, v.y, v.z), uv.push(v.clone().sub(point).dot(a), v.clone().sub(point).dot(b));
        if (i > 1) index.push(0, i - 1, i);
      });
      geometry.setAttribute('position', new BufferAttribute(new Float32Array(at), 3));
      geometry.setAttribute('uv', new BufferAttribute(new Float32Array(uv), 2));
      geometry.setIndex(index);
      geometry.computeVertexNormals();
      // a plane is seen from its free side only, so one looks into a room from outside
      this.scene.add(new Mesh(geometry, new MeshBasicMaterial({map: grid, side: FrontSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1})));
    }
  }
  fit() {
    const {clientWidth: w, clientHeight: h} = this.canvas.parentElement;
    if (!w || !h) return;
    this.renderer.setSize(w, h, false);
    this.camera.aspect = w / h;
    this.camera.updateProjectionMatrix();
    this.draw();
  }
  draw() {
    this.controls.update();
    this.renderer.render(this.scene, this.camera);
  }
  ray(event) {
    const box = this.canvas.getBoundingClientRect(), ray = new Raycaster();
    ray.setFromCamera(new Vector2((event.clientX - box.left) / box.width * 2 - 1, 1 - (event.clientY - box.top) / box.height * 2), this.camera);
    return ray;
  }
  /// {crowd, body, point} under the pointer, or undefined
  pick(event, crowds) {
    const hits = this.ray(event).intersectObjects(crowds.map(c => c.mesh));
    if (hits.length) return {crowd: crowds.find(c => c.mesh === hits[0].object), body: hits[0].instanceId, point: hits[0].point};
  }
}
export {Quaternion, Vector3};
