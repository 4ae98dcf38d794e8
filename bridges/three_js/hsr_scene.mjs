// What a camera of three.js sees, as hsr draws it: vector drawings with hidden lines removed.
//
// In node:     await draw(scene, camera, "drawing.svg", ["--hidden", "dashed"]);
// In browsers: download hsrScene(scene, camera) as "scene.glb", and hand hsrArguments(camera) to `hsr draw scene.glb`.
//
// Imports nothing: it works with the three.js that made the scene.

const FLOAT = 5126, UNSIGNED_INT = 5125, ARRAY = 34962, ELEMENTS = 34963;
const LINES = 1, LINE_LOOP = 2, LINE_STRIP = 3, TRIANGLES = 4;

/**
 * The scene, as it is when the camera would render it, and the camera as "camera": a GLB file, a Uint8Array.
 *
 * Meshes, instances (each an object of its own), skinned and morphed meshes as posed, lines; names, colours of materials,
 * instances and vertices, opacity. Numbers are those of three.js, positions in float32 and world matrices in doubles, but for
 * closeSeams().
 * Left out: what is invisible, or on layers that the camera does not see. Passed over with one line to `warn`: sprites, points,
 * BatchedMesh, what shaders place (fat lines, too), textures. All faces are seen from both sides.
 *
 * @throws Error for a camera that is neither perspective nor orthographic
 */
export function hsrScene(scene, camera, { warn = console.warn } = {}) {
  scene.updateMatrixWorld();
  camera.updateWorldMatrix(true, false);  // it may stand outside of the scene
  const file = new Glb();
  const passedOver = new Set();
  const visit = (object) => {
    if (!object.visible) return;
    if (object.isLOD && object.autoUpdate) object.update(camera);
    if (object.layers.test(camera.layers)) addObject(file, object, passedOver);
    object.children.forEach(visit);
  };
  visit(scene);
  addCamera(file, camera);
  if (passedOver.size > 0) warn(`hsr: passed over: ${[...passedOver].sort().join(", ")}`);
  return file.bytes();
}

/**
 * The arguments of `hsr draw` for a scene by hsrScene: the view through the camera, and for a perspective a page that has the
 * camera's proportions inside its margins, `longerSide` mm in all. An orthographic camera gives its direction: all of the scene
 * is drawn, whatever its frame.
 */
export function hsrArguments(camera, { longerSide = 297, margin = 10 } = {}) {
  const view = ["--view", "camera:camera"];
  if (!camera.isPerspectiveCamera) return view;
  const { across, up } = lens(camera), scale = (longerSide - 2 * margin) / Math.max(across, up);
  const side = (tangent) => (tangent * scale + 2 * margin).toFixed(3);
  return [...view, "--page", `${side(across)}x${side(up)}mm`, "--margin", String(margin)];
}

/**
 * Draws with the command hsr, in node: `output` is a name or some, whose endings choose svg, pdf, dxf, ...; `options` are more
 * options of `hsr draw`. Resolves to what hsr says.
 *
 * @throws Error with hsr's one line where it refuses
 */
export async function draw(scene, camera, output, options = [], { command = process.env.HSR ?? "hsr", warn } = {}) {
  const { spawnSync } = await import("node:child_process");
  const ownPage = options.some((o) => /^--(page|margin)\b/.test(o));
  const view = ownPage ? hsrArguments(camera).slice(0, 2) : hsrArguments(camera);
  const outputs = [output].flat().flatMap((name) => ["-o", name]);
  const ran = spawnSync(command, ["draw", "-", "--from", "glb", ...outputs, ...view, ...options], {
    input: hsrScene(scene, camera, { warn }),
    maxBuffer: 2 ** 30,
  });
  if (ran.error) throw new Error(`hsr: ${command} cannot be run (${ran.error.code}): put it on PATH, or its name in HSR`);
  const said = ran.stderr.toString().trim();
  if (ran.status !== 0) throw new Error(said.split("\n").at(-1) || `hsr: ended with status ${ran.status}`);
  return said;
}

/** Tangents of half the angles that the camera frames. One whose axis is not in the middle gets the least frame around it. */
function lens(camera) {
  camera.updateProjectionMatrix();
  const p = camera.projectionMatrix.elements;  // with zoom, film offset and view offset
  return { across: (1 + Math.abs(p[8])) / p[0], up: (1 + Math.abs(p[9])) / p[5] };
}

function addCamera(file, camera) {
  const json = { type: "orthographic", orthographic: { xmag: 1, ymag: 1, znear: 0, zfar: 1 } };
  if (camera.isPerspectiveCamera) {
    const { across, up } = lens(camera);
    json.type = "perspective";
    delete json.orthographic;
    json.perspective = { yfov: 2 * Math.atan(up), aspectRatio: across / up, znear: camera.near };
  } else if (!camera.isOrthographicCamera) {
    throw new Error(`hsr: found a ${camera.type}, expected a perspective or an orthographic camera`);
  }
  file.json.cameras = [json];
  file.addNode({ name: "camera", camera: 0 }, camera.matrixWorld);
}

function addObject(file, object, passedOver) {
  if (object.isSprite || object.isPoints || object.isBatchedMesh) return void passedOver.add(object.type);
  if (!object.isMesh && !object.isLine) return;
  if (object.geometry.isInstancedBufferGeometry) return void passedOver.add(object.geometry.type);  // fat lines, too
  const name = object.name || object.type;
  if (!object.isInstancedMesh) {
    const mesh = meshOf(file, object, null, passedOver);
    if (mesh !== null) file.addNode({ name, mesh }, object.matrixWorld);
    return;
  }
  const matrix = object.matrixWorld.clone();
  for (let i = 0; i < object.count; ++i) {
    const colour = object.instanceColor ? [0, 1, 2].map((c) => object.instanceColor.getComponent(i, c)) : null;
    const mesh = meshOf(file, object, colour, passedOver);
    if (mesh === null) return;
    object.getMatrixAt(i, matrix);
    file.addNode({ name, mesh }, matrix.premultiply(object.matrixWorld));
  }
}

/** The number of a mesh of the file, or null where there is nothing to draw. */
function meshOf(file, object, colour, passedOver) {
  const geometry = object.geometry, materials = [object.material].flat();
  const posed = object.isSkinnedMesh || (object.morphTargetInfluences?.length ?? 0) > 0;
  const key = posed ? null : [geometry.id, object.type, colour, ...materials.map((m) => m.id)].join();
  if (key !== null && file.meshes.has(key)) return file.meshes.get(key);
  const primitives = [];
  const groups = Array.isArray(object.material) ? geometry.groups : [{ start: 0, count: Infinity, materialIndex: 0 }];
  const positions = geometry.getAttribute("position");
  if (positions !== undefined && positions.count > 0) {
    const attributes = { POSITION: posed ? posedPositions(file, object) : file.vectors(positions, 3, closeSeams) };
    for (const group of groups) {
      const material = materials[group.materialIndex];
      if (!material?.visible) continue;
      const indices = cornersOf(geometry, group, object);
      if (indices.length === 0) continue;
      if (material.map) passedOver.add("textures");
      const colours = material.vertexColors ? geometry.getAttribute("color") : undefined;
      primitives.push({
        attributes: colours ? { ...attributes, COLOR_0: file.vectors(colours, colours.itemSize) } : attributes,
        indices: file.add(indices, UNSIGNED_INT, "SCALAR", indices.length, ELEMENTS),
        material: file.material(material, colour),
        mode: object.isLineLoop ? LINE_LOOP : object.isLineSegments ? LINES : object.isLine ? LINE_STRIP : TRIANGLES,
      });
    }
  }
  const number = primitives.length === 0 ? null : file.json.meshes.push({ primitives }) - 1;
  if (key !== null) file.meshes.set(key, number);
  return number;
}

/** What of the geometry a group and the draw range show. */
function cornersOf(geometry, group, object) {
  const index = geometry.index, all = index ? index.count : geometry.getAttribute("position").count;
  const { start, count } = geometry.drawRange;
  const first = Math.max(group.start, start), end = Math.min(group.start + group.count, start + count, all);
  const size = object.isMesh ? 3 : object.isLineSegments ? 2 : 1;
  const n = Math.max(0, Math.floor((end - first) / size) * size);
  return Uint32Array.from({ length: n }, (_, i) => (index ? index.getX(first + i) : first + i));
}

function posedPositions(file, object) {
  const n = object.geometry.getAttribute("position").count, point = object.position.clone();
  const numbers = new Float32Array(3 * n);
  for (let i = 0; i < n; ++i) object.getVertexPosition(i, point).toArray(numbers, 3 * i);
  return file.add(closeSeams(numbers), FLOAT, "VEC3", n, ARRAY);
}

/**
 * Makes 0 what is below 2^-40 of the largest number. Spheres, cylinders and tori of three.js end where they began but for
 * Math.sin(2 * Math.PI), which is -2e-16: as given, each has a slit of that width with a boundary on either side.
 */
function closeSeams(numbers) {
  const noise = numbers.reduce((most, x) => Math.max(most, Math.abs(x)), 0) * 2 ** -40;
  return numbers.map((x) => (Math.abs(x) < noise ? 0 : x));
}

/** A GLB file that grows. */
class Glb {
  json = { asset: { version: "2.0" }, scene: 0, scenes: [{ nodes: [] }], nodes: [], meshes: [], materials: [], accessors: [],
           bufferViews: [], buffers: [] };
  meshes = new Map();
  #chunks = [];
  #size = 0;
  #materials = new Map();
  #vectors = new Map();

  addNode(node, matrix) {
    this.json.scenes[0].nodes.push(this.json.nodes.push({ ...node, matrix: matrix.elements.map((x) => x + 0) }) - 1);
  }

  add(numbers, componentType, type, count, target) {
    const view = { buffer: 0, byteOffset: this.#size, byteLength: numbers.byteLength, target };
    const bufferView = this.json.bufferViews.push(view) - 1;
    this.#chunks.push(new Uint8Array(numbers.buffer, numbers.byteOffset, numbers.byteLength));
    this.#size += numbers.byteLength;  // a multiple of 4
    return this.json.accessors.push({ bufferView, componentType, count, type }) - 1;
  }

  vectors(attribute, size, change = (numbers) => numbers) {
    if (!this.#vectors.has(attribute)) {
      const numbers = Float32Array.from({ length: attribute.count * size }, (_, i) =>
        attribute.getComponent(Math.floor(i / size), i % size));
      this.#vectors.set(attribute, this.add(change(numbers), FLOAT, `VEC${size}`, attribute.count, ARRAY));
    }
    return this.#vectors.get(attribute);
  }

  material(given, colour) {
    const key = `${given.id} ${colour}`;
    if (!this.#materials.has(key)) {
      const light = given.color ? given.color.toArray() : [1, 1, 1];  // linear, as glTF has it
      const opacity = given.transparent ? given.opacity : 1;
      this.#materials.set(key, this.json.materials.push({
        ...(given.name && { name: given.name }),
        pbrMetallicRoughness: { baseColorFactor: [...light.map((x, i) => x * (colour?.[i] ?? 1)), opacity] },
        alphaMode: opacity < 1 ? "BLEND" : "OPAQUE",
      }) - 1);
    }
    return this.#materials.get(key);
  }

  bytes() {
    const json = Object.fromEntries(Object.entries(this.json).filter(([, value]) => value.length !== 0));
    if (this.#size > 0) json.buffers = [{ byteLength: this.#size }];
    let text = new TextEncoder().encode(JSON.stringify(json));
    text = Uint8Array.from({ length: Math.ceil(text.length / 4) * 4 }, (_, i) => text[i] ?? 32);
    const size = 12 + 8 + text.length + (this.#size > 0 ? 8 + this.#size : 0);
    const file = new Uint8Array(size), words = new DataView(file.buffer);
    [0x46546c67, 2, size, text.length, 0x4e4f534a].forEach((word, i) => words.setUint32(4 * i, word, true));
    file.set(text, 20);
    if (this.#size > 0) {
      let at = 20 + text.length;
      [this.#size, 0x004e4942].forEach((word, i) => words.setUint32(at + 4 * i, word, true));
      at += 8;
      for (const chunk of this.#chunks) {
        file.set(chunk, at);
        at += chunk.length;
      }
    }
    return file;
  }
}
