import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * Writes the ray tree of one pixel as raytree/1.0. Needs Java 11 and nothing else.
 *
 * <pre>
 *     RaytreeRecorder recorder = new RaytreeRecorder(i, j);
 *     RaytreeRecorder.Ray ray = recorder.ray("primary", null, eye, direction);
 *     ray.hit("ball", t).atHit("normal", n).set("intensity", colour);
 *     recorder.save(Path.of("tree.json"));
 * </pre>
 *
 * One call of ray (or shadow) for each ray is enough; what else is said of it is compared too. A
 * vector or colour is a double[3].
 */
public final class RaytreeRecorder {
    private final int column;
    private final int row;
    private final List<Ray> rays = new ArrayList<>();

    public RaytreeRecorder(int column, int row) {
        this.column = column;
        this.row = row;
    }

    /** What is known of a ray, said in any order. */
    public static final class Ray {
        private final int id;
        private final Map<String, String> fields = new LinkedHashMap<>();
        private final Map<String, String> ofHit = new LinkedHashMap<>();

        private Ray(int id) {
            this.id = id;
        }

        /** A number, or the three of a vector or colour: "weight", "ambient", "diffuse",
         * "specular", "attenuation", "intensity"; of a shadow ray "distance", "transmittance". */
        public Ray set(String key, double... value) {
            fields.put(key, text(value));
            return this;
        }

        public Ray set(String key, String word) {
            fields.put(key, text(word));
            return this;
        }

        /** What it hits, t in units of its direction. */
        public Ray hit(String object, double t) {
            ofHit.put("object", text(object));
            ofHit.put("t", text(t));
            return this;
        }

        /** Of its hit: "point", "normal", "cos_incident", "eta", "sin2_transmitted". */
        public Ray atHit(String key, double... value) {
            ofHit.put(key, text(value));
            return this;
        }

        /** "front" or "back". */
        public Ray side(String side) {
            ofHit.put("side", text(side));
            return this;
        }

        public Ray miss() {
            fields.put("hit", "null");
            return this;
        }

        /** Of a shadow ray: the name of what stands between; null where nothing does. */
        public Ray blockedBy(String object) {
            fields.put("blocked_by", object == null ? "null" : "{\"object\": " + text(object) + "}");
            return this;
        }

        private String json() {
            if (!ofHit.isEmpty()) {
                fields.put("hit", "{" + members(ofHit) + "}");
            }
            return "{" + members(fields) + "}";
        }
    }

    /** kind is "primary", "reflected" or "refracted"; parent the ray that hit, or null. */
    public Ray ray(String kind, Ray parent, double[] origin, double[] direction) {
        Ray ray = new Ray(rays.size());
        rays.add(ray);
        ray.fields.put("id", Integer.toString(ray.id));
        ray.fields.put("parent", parent == null ? "null" : Integer.toString(parent.id));
        ray.fields.put("kind", text(kind));
        return ray.set("origin", origin).set("direction", direction);
    }

    /** A shadow ray; light is its name in the scene. */
    public Ray shadow(Ray parent, String light, double[] origin, double[] direction) {
        return ray("shadow", parent, origin, direction).set("light", light);
    }

    public String json() {
        return "{\"format\": \"raytree/1.0\", \"pixel\": [" + column + ", " + row + "],\n \"rays\": [\n  "
            + rays.stream().map(Ray::json).collect(Collectors.joining(",\n  ")) + "\n]}\n";
    }

    public void save(Path file) throws IOException {
        Files.writeString(file, json());
    }

    private static String members(Map<String, String> fields) {
        return fields.entrySet().stream().map(e -> text(e.getKey()) + ": " + e.getValue())
            .collect(Collectors.joining(", "));
    }

    private static String text(String words) {
        return '"' + words.replace("\\", "\\\\").replace("\"", "\\\"").replaceAll("\\p{Cntrl}", " ")
            + '"';
    }

    /** What is no number stays visible as a word, which the check then points at. */
    private static String text(double... numbers) {
        List<String> texts = new ArrayList<>();
        for (double x : numbers) {
            texts.add(Double.isFinite(x) ? Double.toString(x) : text(Double.toString(x)));
        }
        return numbers.length == 1 ? texts.get(0) : texts.toString();
    }
}
