/**
 * The smallest tracer that records: the two balls of ../sample-scene.json.
 *
 *     javac *.java && java Sample 16 12 > tree.json
 */
public final class Sample {
    record Ball(String name, double[] centre, double radius, double[] colour, double ka, double kd,
                double kr) {}

    record Hit(Ball ball, double t) {}

    static final Ball[] BALLS = {
        new Ball("ball", vec(0, 0, 0), 1, vec(0.9, 0.9, 0.9), 0.1, 0.3, 0.6),
        new Ball("small", vec(1.2, 0.8, 0.8), 0.4, vec(0.8, 0.4, 0.2), 0.2, 0.7, 0.1)};
    static final double[] BACKGROUND = vec(0.1, 0.2, 0.3);
    static final double[] LAMP = vec(3, 5, 4);

    static double[] vec(double x, double y, double z) {
        return new double[] {x, y, z};
    }

    static double[] along(double[] a, double s, double[] b) {
        return vec(a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]);
    }

    static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    static double[] unit(double[] a) {
        double length = Math.sqrt(dot(a, a));
        return vec(a[0] / length, a[1] / length, a[2] / length);
    }

    static Hit nearest(double[] origin, double[] direction, double until) {
        Hit found = new Hit(null, until);
        for (Ball ball : BALLS) {
            double[] to = along(origin, -1, ball.centre());
            double b = dot(to, direction);
            double root = b * b - dot(to, to) + ball.radius() * ball.radius();
            for (int sign = -1; root >= 0 && sign <= 1; sign += 2) {
                double t = -b + sign * Math.sqrt(root);
                if (t > 1e-6 && t < found.t()) {
                    found = new Hit(ball, t);
                }
            }
        }
        return found;
    }

    static double[] trace(RaytreeRecorder recorder, String kind, RaytreeRecorder.Ray parent,
                          double[] origin, double[] direction, int level) {
        RaytreeRecorder.Ray ray = recorder.ray(kind, parent, origin, direction);
        Hit hit = nearest(origin, direction, Double.POSITIVE_INFINITY);
        if (hit.ball() == null) {
            ray.miss().set("intensity", BACKGROUND);
            return BACKGROUND;
        }
        Ball ball = hit.ball();
        double[] point = along(origin, hit.t(), direction);
        double[] normal = along(vec(0, 0, 0), 1 / ball.radius(), along(point, -1, ball.centre()));
        double[] sum = along(vec(0, 0, 0), ball.ka(), ball.colour());
        double[] toLamp = along(LAMP, -1, point);
        double[] towards = unit(toLamp);
        if (dot(normal, towards) > 0) {
            Ball between = nearest(point, towards, Math.sqrt(dot(toLamp, toLamp))).ball();
            recorder.shadow(ray, "lamp", point, towards)
                .blockedBy(between == null ? null : between.name());
            if (between == null) {
                sum = along(sum, ball.kd() * dot(normal, towards), ball.colour());
            }
        }
        if (level < 4) {
            double[] mirrored = unit(along(direction, -2 * dot(direction, normal), normal));
            sum = along(sum, ball.kr(),
                        trace(recorder, "reflected", ray, point, mirrored, level + 1));
        }
        ray.hit(ball.name(), hit.t()).atHit("normal", normal).set("intensity", sum);
        return sum;
    }

    public static void main(String[] arguments) {
        int i = arguments.length > 1 ? Integer.parseInt(arguments[0]) : 16;
        int j = arguments.length > 1 ? Integer.parseInt(arguments[1]) : 12;
        RaytreeRecorder recorder = new RaytreeRecorder(i, j);
        double[] aim =
            unit(vec(-0.4 + (i + 0.5) * 0.8 / 32, 0.3 - (j + 0.5) * 0.6 / 24, -1));
        trace(recorder, "primary", null, vec(0, 0, 5), aim, 1);
        System.out.print(recorder.json());
    }
}
