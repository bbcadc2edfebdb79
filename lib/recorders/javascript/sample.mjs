// The smallest tracer that records: the two balls of ../sample-scene.json.
//     node sample.mjs 16 12 > tree.json
import {Recorder} from "./raytree-recorder.mjs";

const BALLS = [
  {name: "ball", centre: [0, 0, 0], radius: 1, colour: [0.9, 0.9, 0.9], ka: 0.1, kd: 0.3, kr: 0.6},
  {name: "small", centre: [1.2, 0.8, 0.8], radius: 0.4, colour: [0.8, 0.4, 0.2],
   ka: 0.2, kd: 0.7, kr: 0.1},
];
const BACKGROUND = [0.1, 0.2, 0.3];
const LAMP = [3, 5, 4];

const along = (a, s, b) => a.map((x, k) => x + s * b[k]);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const unit = (a) => a.map((x) => x / Math.sqrt(dot(a, a)));

function nearest(origin, direction, until) {
  let found = null;
  for (const ball of BALLS) {
    const to = along(origin, -1, ball.centre);
    const b = dot(to, direction);
    const root = b * b - dot(to, to) + ball.radius * ball.radius;
    if (root < 0) continue;
    for (const t of [-b - Math.sqrt(root), -b + Math.sqrt(root)]) {
      if (t > 1e-6 && t < until) {
        found = ball;
        until = t;
      }
    }
  }
  return {ball: found, t: until};
}

function trace(recorder, kind, parent, origin, direction, level) {
  const ray = recorder.ray(kind, parent, origin, direction);
  const {ball, t} = nearest(origin, direction, Infinity);
  if (!ball) {
    ray.miss().set({intensity: BACKGROUND});
    return BACKGROUND;
  }
  const point = along(origin, t, direction);
  const normal = along(point, -1, ball.centre).map((x) => x / ball.radius);
  let sum = ball.colour.map((c) => ball.ka * c);
  const toLamp = along(LAMP, -1, point);
  const towards = unit(toLamp);
  if (dot(normal, towards) > 0) {
    const between = nearest(point, towards, Math.sqrt(dot(toLamp, toLamp))).ball;
    recorder.shadow(ray, "lamp", point, towards).blockedBy(between ? between.name : null);
    if (!between) sum = along(sum, ball.kd * dot(normal, towards), ball.colour);
  }
  if (level < 4) {
    const mirrored = unit(along(direction, -2 * dot(direction, normal), normal));
    sum = along(sum, ball.kr, trace(recorder, "reflected", ray, point, mirrored, level + 1));
  }
  ray.hit(ball.name, t, {normal}).set({intensity: sum});
  return sum;
}

const [i, j] = process.argv.length > 3 ? process.argv.slice(2, 4).map(Number) : [16, 12];
const recorder = new Recorder(i, j);
const aim = unit([-0.4 + (i + 0.5) * 0.8 / 32, 0.3 - (j + 0.5) * 0.6 / 24, -1]);
trace(recorder, "primary", null, [0, 0, 5], aim, 1);
process.stdout.write(recorder.json());
