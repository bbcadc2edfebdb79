#pragma once

#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// Writes the ray tree of one pixel as raytree/1.0. Needs C++17 and nothing else.
///
///     raytree::Recorder recorder(i, j);
///     auto ray = recorder.ray("primary", raytree::no_parent, eye, direction);
///     ray.hit("ball", t).set("intensity", colour);
///     recorder.save("tree.json");
///
/// One call of `ray` (or `shadow`) for each ray is enough; what else is said of it is compared too.
/// A vector or colour is anything with x, y, z or with [0], [1], [2].
namespace raytree {
namespace recording {

inline std::string text(const std::string& words) {
    std::string out = "\"";
    for (const char c : words) {
        out += c == '"' || c == '\\' ? "\\" : "";
        out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return out + '"';
}
inline std::string text(const char* words) { return text(std::string(words)); }
/// Every digit; what is no number stays visible as a word, which the check then points at.
inline std::string text(double x) {
    char digits[40];
    std::snprintf(digits, sizeof digits, "%.17g", x);
    for (char& c : digits) {
        c = c == ',' ? '.' : c;  // of some locales
    }
    return std::isnan(x) ? "\"NaN\"" : std::isinf(x) ? "\"infinity\"" : digits;
}

inline std::string list(double x, double y, double z) {
    return '[' + text(x) + ", " + text(y) + ", " + text(z) + ']';
}
template <class V> auto text(const V& v) -> decltype(static_cast<double>(v.z), std::string()) {
    return list(static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z));
}
template <class V, class... Else>  // where it has no x, y, z
auto text(const V& v, Else...) -> decltype(static_cast<double>(v[2]), std::string()) {
    return list(static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2]));
}

using Members = std::vector<std::pair<std::string, std::string>>;  // key and JSON

inline std::string members(const Members& fields) {
    std::string out;
    for (const auto& [key, value] : fields) {
        out += (out.empty() ? "" : ", ") + text(key) + ": " + value;
    }
    return out;
}

struct Entry {
    Members fields, hit;
};

}  // namespace recording

inline constexpr int no_parent = -1;

class Recorder {
  public:
    Recorder(int column, int row) : column_(column), row_(row) {}

    /// What is known of a ray, said in any order. `id` is the parent of the rays that it sends.
    class Ray {
      public:
        /// A number, a vector or colour, or a word: "weight", "ambient", "diffuse", "specular",
        /// "attenuation", "intensity"; of a shadow ray "distance", "transmittance".
        template <class V> Ray& set(const std::string& key, const V& value) {
            return raw(key.c_str(), recording::text(value));
        }
        /// What it hits, `t` in units of its direction.
        Ray& hit(const std::string& object, double t) {
            return at_hit("object", object).at_hit("t", t);
        }
        /// Of its hit: "point", "normal", "side" ("front" or "back"), "sin2_transmitted".
        template <class V> Ray& at_hit(const std::string& key, const V& value) {
            entry().hit.emplace_back(key, recording::text(value));
            return *this;
        }
        Ray& miss() { return raw("hit", "null"); }
        /// Of a shadow ray: what stands between, or that nothing does.
        Ray& blocked_by(const std::string& object) {
            return raw("blocked_by", "{\"object\": " + recording::text(object) + '}');
        }
        Ray& reaches_light() { return raw("blocked_by", "null"); }

        int id;

      private:
        friend class Recorder;
        Ray(Recorder& recorder, int its_id) : id(its_id), recorder_(&recorder) {}
        recording::Entry& entry() { return recorder_->rays_[static_cast<std::size_t>(id)]; }
        Ray& raw(const char* key, const std::string& json) {
            entry().fields.emplace_back(key, json);
            return *this;
        }
        Recorder* recorder_;
    };

    /// `kind` is "primary", "reflected" or "refracted"; `parent` the id of the ray that hit.
    template <class V>
    Ray ray(const std::string& kind, int parent, const V& origin, const V& direction) {
        rays_.emplace_back();
        return Ray(*this, static_cast<int>(rays_.size()) - 1)
            .raw("id", std::to_string(rays_.size() - 1))
            .raw("parent", parent < 0 ? "null" : std::to_string(parent))
            .set("kind", kind)
            .set("origin", origin)
            .set("direction", direction);
    }
    /// A shadow ray; `light` is its name in the scene.
    template <class V>
    Ray shadow(int parent, const std::string& light, const V& origin, const V& direction) {
        return ray("shadow", parent, origin, direction).set("light", light);
    }

    std::string json() const {
        std::string out = "{\"format\": \"raytree/1.0\", \"pixel\": [" + std::to_string(column_) +
                          ", " + std::to_string(row_) + "],\n \"rays\": [";
        for (const recording::Entry& ray : rays_) {
            out += (&ray == &rays_.front() ? "\n  {" : ",\n  {") + recording::members(ray.fields);
            out += ray.hit.empty() ? "}" : ", \"hit\": {" + recording::members(ray.hit) + "}}";
        }
        return out + "\n]}\n";
    }
    void save(const std::string& file) const {
        if (std::ofstream out(file, std::ios::binary); !(out << json()).flush()) {
            throw std::runtime_error("cannot write " + file);
        }
    }

  private:
    int column_, row_;
    std::vector<recording::Entry> rays_;
};

}  // namespace raytree
