#include "formats/tree_vtp.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <span>

#include "formats/json_text.h"

namespace raytree {
namespace {

using Ray = TreeRay<double>;
using Point3 = Vec3<double>;

/// The diagonal of the box around the eye and all hits; 1 where that is nothing.
double extent_of(const RayTree<double>& tree) {
    constexpr double far = std::numeric_limits<double>::infinity();
    Point3 low(far), high(-far);
    const auto cover = [&](const Point3& p) {
        low = {min_of(low.x, p.x), min_of(low.y, p.y), min_of(low.z, p.z)};
        high = {max_of(high.x, p.x), max_of(high.y, p.y), max_of(high.z, p.z)};
    };
    for (const Ray& ray : tree.rays) {
        cover(ray.origin);
        if (ray.hit) {
            cover(ray.hit->point);
        }
    }
    const double extent = tree.rays.empty() ? 0 : length(high - low);
    if (extent > 0) {
        return extent;
    }
    const double to_scene = length(tree.camera.look_at - tree.camera.eye);
    return to_scene > 0 ? to_scene : 1;
}

/// Where the line of a ray ends.
Point3 end_of(const Ray& ray, double escaped_length) {
    if (ray.hit) {
        return ray.hit->point;
    }
    double t = escaped_length;
    if (ray.shadow && ray.shadow->blocked_by) {
        t = ray.shadow->blocked_by->t;
    } else if (ray.shadow && ray.shadow->distance) {
        t = *ray.shadow->distance;
    }
    return along(ray.origin, t, ray.direction);
}

std::string listed(const Point3& p) {
    return json_number(p.x) + " " + json_number(p.y) + " " + json_number(p.z);
}
std::string listed(const Rgb<double>& c) {
    return json_number(c.r) + " " + json_number(c.g) + " " + json_number(c.b);
}

/// A DataArray with a line for each ray.
class PolyData {
  public:
    explicit PolyData(std::span<const Ray> rays) : rays_(rays) {}

    void open(const std::string& tag) { text_ += indent() + "<" + tag + ">\n", ++depth_; }
    void close(const std::string& tag) { --depth_, text_ += indent() + "</" + tag + ">\n"; }

    void array(const std::string& attributes, const std::function<std::string(const Ray&)>& value) {
        open("DataArray " + attributes + " format=\"ascii\"");
        for (const Ray& ray : rays_) {
            text_ += indent() + value(ray) + "\n";
        }
        close("DataArray");
    }
    /// Words are written as the codes of their characters, each word ended by 0.
    template <class Words> void words(const std::string& name, const Words& words) {
        open("Array type=\"String\" Name=\"" + name + "\" NumberOfTuples=\"" +
             std::to_string(words.size()) + "\" format=\"ascii\"");
        for (const auto word : words) {
            text_ += indent();
            for (const char c : word) {
                text_ += std::to_string(static_cast<int>(c)) + " ";
            }
            text_ += "0\n";
        }
        close("Array");
    }
    std::string take() { return std::move(text_); }

  private:
    std::string indent() const { return std::string(2 * depth_, ' '); }

    std::span<const Ray> rays_;
    std::string text_;
    std::size_t depth_ = 0;
};

void write_cell_data(PolyData& out) {
    out.open("CellData Scalars=\"kind\"");
    out.array("type=\"Int64\" Name=\"id\"", [](const Ray& ray) { return std::to_string(ray.id); });
    out.array("type=\"Int64\" Name=\"parent\"", [](const Ray& ray) {
        return ray.parent ? std::to_string(*ray.parent) : std::string("-1");
    });
    out.array("type=\"Int32\" Name=\"kind\"",
              [](const Ray& ray) { return std::to_string(static_cast<int>(ray.kind)); });
    out.array("type=\"Int32\" Name=\"level\"",
              [](const Ray& ray) { return std::to_string(ray.level); });
    out.array("type=\"Int32\" Name=\"termination\"", [](const Ray& ray) {
        return std::to_string(ray.termination ? static_cast<int>(*ray.termination) : -1);
    });
    out.array("type=\"Int32\" Name=\"blocked\"", [](const Ray& ray) {
        return std::string(ray.shadow && is_zero(ray.shadow->transmittance) ? "1" : "0");
    });
    out.array("type=\"Float64\" Name=\"weight\" NumberOfComponents=\"3\"",
              [](const Ray& ray) { return listed(ray.weight); });
    out.array("type=\"Float64\" Name=\"intensity\" NumberOfComponents=\"3\"", [](const Ray& ray) {
        return listed(ray.shadow ? ray.diffuse + ray.specular : ray.intensity);
    });
    out.close("CellData");
}

void write_lines(PolyData& out, double escaped_length) {
    out.open("Points");
    out.array("type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"",
              [escaped_length](const Ray& ray) {
                  return listed(ray.origin) + " " + listed(end_of(ray, escaped_length));
              });
    out.close("Points");
    out.open("Lines");
    out.array("type=\"Int64\" Name=\"connectivity\"", [](const Ray& ray) {
        return std::to_string(2 * ray.id) + " " + std::to_string(2 * ray.id + 1);
    });
    out.array("type=\"Int64\" Name=\"offsets\"",
              [](const Ray& ray) { return std::to_string(2 * ray.id + 2); });
    out.close("Lines");
}

void write_words(PolyData& out) {
    std::vector<std::string_view> kinds, reasons;
    for (int kind = 0; kind < 4; ++kind) {
        kinds.push_back(word_of(static_cast<RayKind>(kind)));
    }
    for (const ReasonText& text : reason_texts()) {
        reasons.push_back(text.word);
    }
    out.open("FieldData");
    out.words("kinds", kinds);
    out.words("terminations", reasons);
    out.close("FieldData");
}

}  // namespace

std::string write_tree_vtp(const RayTree<double>& tree) {
    const std::string rays = std::to_string(tree.rays.size());
    const std::string points = std::to_string(2 * tree.rays.size());
    PolyData out(tree.rays);
    out.open("VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\"");
    out.open("PolyData");
    write_words(out);
    out.open("Piece NumberOfPoints=\"" + points + "\" NumberOfLines=\"" + rays + "\"");
    write_cell_data(out);
    write_lines(out, extent_of(tree) / 4);
    out.close("Piece");
    out.close("PolyData");
    out.close("VTKFile");
    return "<?xml version=\"1.0\"?>\n" + out.take();
}

}  // namespace raytree
