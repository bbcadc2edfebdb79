// Writes the ray tree of one pixel as raytree/1.0. Needs nothing else, in a browser or in Node.
//
//     const recorder = new Recorder(i, j);
//     const ray = recorder.ray("primary", null, eye, direction);
//     ray.hit("ball", t, {normal}).set({intensity: colour});
//     console.log(recorder.json());
//
// One call of `ray` (or `shadow`) for each ray is enough; what else is said of it is compared too.
// A vector or colour is an array, a typed array, or an object with x, y, z or r, g, b.

// As JSON has it. What is no number stays visible as a word, which the check then points at.
function plain(value) {
  if (typeof value === "number") return Number.isFinite(value) ? value : String(value);
  if (value === null || typeof value !== "object") return value;
  if (ArrayBuffer.isView(value) || Array.isArray(value)) return Array.from(value, plain);
  if ("z" in value) return [value.x, value.y, value.z].map(plain);
  if ("b" in value) return [value.r, value.g, value.b].map(plain);
  return Object.fromEntries(Object.entries(value).map(([key, each]) => [key, plain(each)]));
}

class Ray {
  constructor(fields) {
    this.fields = fields;
  }

  // weight, ambient, diffuse, specular, attenuation, intensity; of a shadow ray distance,
  // transmittance.
  set(fields) {
    Object.assign(this.fields, plain(fields));
    return this;
  }

  // What it hits, t in units of its direction; more: point, normal, side ("front" or "back"),
  // cos_incident, eta, sin2_transmitted.
  hit(object, t, more = {}) {
    this.fields.hit = plain({object, t, ...more});
    return this;
  }

  miss() {
    this.fields.hit = null;
    return this;
  }

  // Of a shadow ray: the name of what stands between; null where nothing does.
  blockedBy(object) {
    this.fields.blocked_by = object === null ? null : {object};
    return this;
  }
}

export class Recorder {
  constructor(column, row) {
    this.pixel = [column, row];
    this.rays = [];
  }

  // kind is "primary", "reflected" or "refracted"; parent the Ray that hit, or null.
  ray(kind, parent, origin, direction, fields = {}) {
    const ray = new Ray({id: this.rays.length, parent: parent ? parent.fields.id : null, kind});
    this.rays.push(ray.fields);
    return ray.set({origin, direction, ...fields});
  }

  // A shadow ray; light is its name in the scene.
  shadow(parent, light, origin, direction, fields = {}) {
    return this.ray("shadow", parent, origin, direction, {light, ...fields});
  }

  json() {
    const rows = this.rays.map((ray) => JSON.stringify(ray)).join(",\n  ");
    const pixel = JSON.stringify(this.pixel);
    return `{"format": "raytree/1.0", "pixel": ${pixel},\n "rays": [\n  ${rows}\n]}\n`;
  }
}
