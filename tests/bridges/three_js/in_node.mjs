// What hsr draws of a scene of three.js is, to the last bit, what it draws of the same scene written by hand, and it is where the
// camera of three.js puts it. run.py runs this in node, with the package three and BRIDGE, the file to test, beside it,
// HSR, the command, and PAGE, the document.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after, test } from "node:test";
import { pathToFileURL } from "node:url";

const THREE = await import("three");
const { draw, hsrArguments, hsrScene } = await import(pathToFileURL(process.env.BRIDGE));
const command = process.env.HSR;
const directory = mkdtempSync(join(tmpdir(), "hsr-three-"));
after(() => rmSync(directory, { recursive: true }));
const file = (name) => join(directory, name);

const QUADS = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
const TRIANGLES = QUADS.flatMap(([a, b, c, d]) => [[a, b, c], [a, c, d]]);

function boxCorners([x, y, z], [a, b, c]) {
  return [0, 1, 2, 3, 4, 5, 6, 7].map((k) => [x + (k & 4 ? a : 0), y + (k & 2 ? b : 0), z + (k & 1 ? c : 0)]);
}

function geometry(points, triangles, { indexed }) {
  const g = new THREE.BufferGeometry();
  const order = indexed ? points : triangles.flat().map((k) => points[k]);
  g.setAttribute("position", new THREE.BufferAttribute(new Float32Array(order.flat()), 3));
  if (indexed) g.setIndex(triangles.flat());
  return g;
}

/** The scene of three.js. All numbers are dyadic, so that no product of matrices rounds. */
function threeScene() {
  const scene = new THREE.Scene();
  const unit = boxCorners([0, 0, 0], [1, 1, 1]);
  const grey = new THREE.MeshBasicMaterial({ color: 0x808080 });
  const named = (name, object) => Object.assign(object, { name });
  const house = new THREE.Group(), storey = new THREE.Group();
  house.position.set(-2, 0.25, 0.5);
  house.scale.set(2, 2, 2);
  storey.position.set(0.5, 0, -0.25);
  storey.add(named("indexed", new THREE.Mesh(geometry(unit, TRIANGLES, { indexed: true }), grey)));
  house.add(storey);
  scene.add(house);
  const loose = named("unindexed", new THREE.Mesh(geometry(unit, TRIANGLES, { indexed: false }), grey));
  loose.position.set(1.5, 1, 1.25);
  scene.add(loose);
  const post = geometry(unit, TRIANGLES, { indexed: true });
  const posts = named("post", new THREE.InstancedMesh(post, new THREE.MeshBasicMaterial(), 3));
  posts.position.set(0, 0.5, 3);
  for (let i = 0; i < 3; ++i) {
    posts.setMatrixAt(i, new THREE.Matrix4().makeTranslation(1.5 * i - 1, 0, 0).scale(new THREE.Vector3(0.5, 3, 0.5)));
    posts.setColorAt(i, new THREE.Color([1, 0, 0][i], [0, 1, 0][i], [0, 0, 1][i]));
  }
  scene.add(posts);
  const floor = geometry([[-4, 0, -2], [0, 0, -2], [4, 0, -2], [-4, 0, 5], [0, 0, 5], [4, 0, 5]],
                         [[0, 3, 4], [0, 4, 1], [1, 4, 5], [1, 5, 2]], { indexed: true });
  floor.addGroup(0, 6, 1);
  floor.addGroup(6, 6, 0);
  scene.add(named("floor", new THREE.Mesh(floor, [new THREE.MeshBasicMaterial({ color: "white" }),
                                                  new THREE.MeshBasicMaterial({ color: "black" })])));
  const wire = new THREE.BufferGeometry().setFromPoints([[-3, 1, 4], [3, 1, 4], [3, 2, -1]].map((p) => new THREE.Vector3(...p)));
  scene.add(named("wire", new THREE.Line(wire)));
  // What must not be there.
  const hidden = new THREE.Group();
  hidden.visible = false;
  hidden.add(new THREE.Mesh(geometry(boxCorners([-9, 0, 0], [30, 30, 30]), TRIANGLES, { indexed: true }), grey));
  scene.add(hidden);
  const elsewhere = new THREE.Mesh(geometry(boxCorners([-1, 4, -1], [2, 2, 2]), TRIANGLES, { indexed: true }), grey);
  elsewhere.layers.set(3);
  scene.add(elsewhere);
  const clear = grey.clone();
  clear.visible = false;
  scene.add(new THREE.Mesh(elsewhere.geometry, clear));
  return scene;
}

/** The same by hand: an OBJ file of boxes with quadrangles, where they are in the world. */
function directScene() {
  const boxes = [
    ["indexed", [-1, 0.25, 0], [2, 2, 2]],
    ["unindexed", [1.5, 1, 1.25], [1, 1, 1]],
    ["post", [-1, 0.5, 3], [0.5, 3, 0.5]],
    ["post [2]", [0.5, 0.5, 3], [0.5, 3, 0.5]],
    ["post [3]", [2, 0.5, 3], [0.5, 3, 0.5]],
  ];
  let text = "", points = 0;
  const add = (corners, faces) => {
    for (const p of corners) text += `v ${p.join(" ")}\n`;
    for (const f of faces) text += (f.length === 2 ? "l " : "f ") + f.map((k) => k + 1 + points).join(" ") + "\n";
    points += corners.length;
  };
  for (const [name, at, size] of boxes) {
    text += `o ${name}\nusemtl grey\n`;
    add(boxCorners(at, size), QUADS);
  }
  text += "o floor\nusemtl black\n";
  add([[-4, 0, -2], [0, 0, -2], [0, 0, 5], [-4, 0, 5]], [[0, 1, 2, 3]]);
  text += "usemtl white\n";
  add([[0, 0, -2], [4, 0, -2], [4, 0, 5], [0, 0, 5]], [[0, 1, 2, 3]]);
  text += "o wire\n";
  add([[-3, 1, 4], [3, 1, 4], [3, 2, -1]], [[0, 1], [1, 2]]);
  return text;
}

/** Class, object, visible and hidden parts of each line, as exact text, whichever way round it is stored. */
function lines(json) {
  const ends = (parts) => parts.map((part) => part.map((p) => p.join(" ")).sort().join(" to ")).sort().join("; ");
  const said = ({ object, visible_points, hidden_points, ...line }) =>
    `${line.class} ${json.objects[object] ?? "none"} visible ${ends(visible_points)} hidden ${ends(hidden_points)}`;
  return json.lines.map(said).sort();
}

function drawnDirectly(view) {
  const options = ["--from", "obj", "--up-axis", "y", "-o", file("direct.json"), "--exact", "--hidden", "dashed", ...view];
  const ran = spawnSync(command, ["draw", "-", ...options], { input: directScene(), encoding: "utf8" });
  assert.equal(ran.status, 0, ran.stderr);
  return lines(JSON.parse(readFileSync(file("direct.json"))));
}

const numbers = (e, from) => [e[from], e[from + 1], e[from + 2]].map((x) => x + 0).join(",");

function perspective() {
  const camera = new THREE.PerspectiveCamera(40, 1.5, 0.5, 100);
  camera.position.set(5, 4.5, 9.25);
  camera.lookAt(0, 1, 1);
  return camera;
}

async function drawnByThree(camera) {
  await draw(threeScene(), camera, file("three.json"), ["--exact", "--hidden", "dashed"], { command });
  return lines(JSON.parse(readFileSync(file("three.json"))));
}

test("a perspective camera shows exactly the lines of the same scene made by hand", async () => {
  const drawn = await drawnByThree(perspective());
  assert.deepEqual(drawn, drawnDirectly(["--eye=5,4.5,9.25", "--target=0,1,1", "--near=0.5"]));
  await draw(threeScene(), perspective(), file("near.json"), [], { command });
  const { near, eye, target } = JSON.parse(readFileSync(file("near.json"))).view;  // near: in distances of the target
  assert(Math.abs(near * Math.hypot(...target.map((x, k) => x - eye[k])) - 0.5) < 1e-12);
  assert(drawn.some((line) => line.startsWith("material floor")));
  assert(drawn.some((line) => line.startsWith("wire")));
  assert.equal(new Set(drawn.map((line) => line.match(/post( \[\d\])?/)?.[0])).size, 4);
});

test("an orthographic camera shows exactly the lines of the same scene made by hand", async () => {
  const camera = new THREE.OrthographicCamera(-6, 6, 4, -4, 0.1, 100);
  camera.position.set(5, 4.5, 9.25);
  camera.lookAt(0, 1, 1);
  camera.updateMatrixWorld();
  const z = new THREE.Vector3(5, 3.5, 8.25).normalize();
  z.toArray().forEach((x, k) => assert(Math.abs(x - camera.matrixWorld.elements[8 + k]) < 1e-15));
  assert.deepEqual(await drawnByThree(camera), drawnDirectly([`--direction=${numbers(camera.matrixWorld.elements, 8)}`]));
});

test("on the page a point is where the camera of three.js puts it", async () => {
  const cases = { wide: [1.5, () => {}], tall: [0.6, () => {}], zoomed: [1.5, (c) => { c.zoom = 1.25; }],
                  shifted: [1.5, (c) => c.setViewOffset(300, 200, 60, -20, 300, 200)], film: [1.5, (c) => { c.filmOffset = 4; }] };
  for (const [name, [aspect, change]] of Object.entries(cases)) {
    const camera = perspective();
    camera.aspect = aspect;
    change(camera);  // which draw notices by itself
    await draw(threeScene(), camera, file("page.svg"), ["--hidden", "solid"], { command });
    const svg = readFileSync(file("page.svg"), "utf8");
    const [width, height] = svg.match(/viewBox="0 0 ([\d.]+) ([\d.]+)"/).slice(1).map(Number);
    const drawn = [...svg.matchAll(/ d="M([^"]*)"/g)].flatMap(([, d]) => d.replace(/[ZM]/g, " ").trim().split(/\s+/).map(Number));
    camera.updateProjectionMatrix();
    // Half of what is framed, from the corners of the frame of three.js.
    const corner = (x, y) => new THREE.Vector3(x, y, -1).applyMatrix4(camera.projectionMatrixInverse);
    const low = corner(-1, -1), high = corner(1, 1);
    const across = Math.max(-low.x, high.x) / -low.z, up = Math.max(-low.y, high.y) / -low.z;
    const near = (across / up) * ((height - 20) / (width - 20));
    assert(Math.abs(near - 1) < 1e-4, `${name}: the page has other proportions than the camera`);
    let inside = 0;
    for (const p of [[-1, 3.5, 3], [2.5, 3.5, 3], [2.5, 3.5, 3.5], [2.5, 2, 1.25], [1, 2.25, 2], [-1, 2.25, 0]]) {
      const q = new THREE.Vector3(...p).applyMatrix4(camera.matrixWorldInverse);
      const x = width / 2 + (q.x / -q.z / across) * (width / 2 - 10), y = height / 2 - (q.y / -q.z / up) * (height / 2 - 10);
      if (x < 10 || y < 10 || x > width - 10 || y > height - 10) continue;
      ++inside;
      const away = Math.min(...drawn.map((number, k) => (k % 2 ? Infinity : Math.hypot(number - x, drawn[k + 1] - y))));
      assert(away < 0.002, `${name}: ${p} is ${away} mm away from where it should be`);
    }
    assert(inside >= 3, `${name}: ${inside} points are in the picture`);
  }
});

test("colours of materials, instances and vertices arrive", async () => {
  const scene = threeScene(), painted = geometry(boxCorners([-3, 0.5, 4], [0.5, 0.5, 0.5]), TRIANGLES, { indexed: true });
  painted.setAttribute("color", new THREE.BufferAttribute(new Float32Array(Array(8).fill([1, 1, 0]).flat()), 3));
  scene.add(new THREE.Mesh(painted, new THREE.MeshBasicMaterial({ vertexColors: true })));
  await draw(scene, perspective(), file("colours.svg"), ["--fill", "--shade", "none"], { command });
  const svg = readFileSync(file("colours.svg"), "utf8");
  for (const colour of ["#ff0000", "#00ff00", "#0000ff", "#ffff00", "#808080", "#ffffff", "#000000"])
    assert(svg.includes(`fill="${colour}"`), colour);
});

test("the round bodies of three.js are closed, and posed ones are drawn as posed", async () => {
  const scene = new THREE.Scene(), camera = perspective();
  const shapes = [new THREE.SphereGeometry(1, 32, 16), new THREE.CylinderGeometry(1, 1, 2, 32), new THREE.ConeGeometry(1, 2, 32),
                  new THREE.TorusGeometry(1, 0.25, 16, 32), new THREE.CapsuleGeometry(0.5, 1, 8, 16)];
  for (const shape of shapes) scene.add(new THREE.Mesh(shape, new THREE.MeshNormalMaterial()));
  writeFileSync(file("round.glb"), hsrScene(scene, camera));
  const ran = spawnSync(command, ["info", file("round.glb")], { encoding: "utf8" });
  assert.match(ran.stdout, /closed\s+yes/);

  const morphed = geometry(boxCorners([0, 0, 0], [1, 1, 1]), TRIANGLES, { indexed: true });
  morphed.morphAttributes.position = [new THREE.BufferAttribute(new Float32Array(boxCorners([0, 0, 0], [1, 3, 1]).flat()), 3)];
  const mesh = new THREE.Mesh(morphed, new THREE.MeshBasicMaterial());
  mesh.morphTargetInfluences = [1];
  writeFileSync(file("morphed.glb"), hsrScene(new THREE.Scene().add(mesh), camera));
  const told = spawnSync(command, ["info", file("morphed.glb")], { encoding: "utf8" });
  assert.match(told.stdout, /box\s+0 0 0 to 1 3 1/);
});

test("the program of the document draws", () => {
  const [, program] = readFileSync(process.env.PAGE, "utf8").match(/```js\n([^]*?) *```/);
  const there = mkdtempSync(join(dirname(process.env.BRIDGE), "page-"));
  try {
    writeFileSync(join(there, "page.mjs"), program.replace("./hsr_scene.mjs", "../hsr_scene.mjs"));
    const ran = spawnSync(process.execPath, ["page.mjs"], { cwd: there, encoding: "utf8" });
    assert.equal(ran.status, 0, ran.stderr);
    assert.match(readFileSync(join(there, "knot.svg"), "utf8"), /data-object="Mesh"|id="hidden-outline"/);
    assert.equal(readFileSync(join(there, "knot.pdf"), "latin1").slice(0, 5), "%PDF-");
  } finally {
    rmSync(there, { recursive: true });
  }
});

test("what goes wrong is said in one line, and what is passed over", async () => {
  const one = (text) => ({ message }) => message.startsWith("hsr: ") && message.includes(text) && !message.includes("\n");
  const scene = threeScene(), camera = perspective();
  await assert.rejects(draw(scene, camera, file("x.xyz"), [], { command }), one("x.xyz"));
  await assert.rejects(draw(scene, camera, file("x.svg"), [], { command: "/nowhere/hsr" }), one("cannot be run"));
  await assert.rejects(draw(scene, new THREE.Camera(), file("x.svg"), [], { command }), one("expected a perspective"));
  const said = [];
  scene.add(new THREE.Sprite(), new THREE.Points(), new THREE.Mesh(new THREE.InstancedBufferGeometry()));
  hsrScene(scene, camera, { warn: (text) => said.push(text) });
  assert.deepEqual(said, ["hsr: passed over: InstancedBufferGeometry, Points, Sprite"]);
  assert.deepEqual(hsrArguments(new THREE.OrthographicCamera()), ["--view", "camera:camera"]);
});
