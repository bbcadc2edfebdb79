#include "formats/scene_json.h"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <utility>

#include "formats/did_you_mean.h"
#include "formats/obj.h"
#include "formats/scene_words.h"
#include "scene/progress.h"
#include "scene/validate.h"

namespace raytree {
namespace {

/// Reads materials, lights and objects; knows the materials' names.
class SceneReader {
  public:
    SceneReader(const std::filesystem::path& folder, JsonReport& report)
        : folder_(folder), report_(report) {}

    Scene read(const Json& document);

  private:
    template <class ReadElement>
    void list(const ObjectReader& reader, std::string_view key, ReadElement read_element);
    void named_materials(const ObjectReader& reader);
    Material material(const Json& value, const JsonPlace& place);
    void light(const Json& value, const JsonPlace& place, std::size_t index);
    void object(const Json& value, const JsonPlace& place, std::size_t index);
    Shape shape(const ObjectReader& reader, std::size_t type);
    Mesh mesh(const ObjectReader& reader);
    std::size_t object_material(const ObjectReader& reader, const std::string& object_name);
    std::optional<Affine> transform(const ObjectReader& reader);

    const std::filesystem::path& folder_;
    JsonReport& report_;
    Scene scene_;
    std::unordered_map<std::string_view, std::size_t> materials_;  // views of the document's keys
};

Scene SceneReader::read(const Json& document) {
    const JsonPlace top;
    const ObjectReader reader(document, top, report_);
    reader.text("name", scene_.name, Need::optional);
    reader.colour("background", scene_.background, Need::optional);
    reader.colour("ambient", scene_.ambient, Need::optional);
    if (const Json* const camera = reader.need("camera", "an object")) {
        scene_.camera = read_camera_json(*camera, reader.place_of("camera"), report_);
    }
    if (const Json* const settings = reader.find("settings")) {
        scene_.settings = read_settings_json(*settings, reader.place_of("settings"), report_);
    }
    named_materials(reader);
    list(reader, "lights", [this](auto&&... element) { light(element...); });
    reader.need("objects", "a list of objects");
    list(reader, "objects", [this](auto&&... element) { object(element...); });
    reader.nothing_but({"format", "name", "camera", "background", "ambient", "settings",
                        "materials", "lights", "objects"});
    return std::move(scene_);
}

template <class ReadElement>
void SceneReader::list(const ObjectReader& reader, std::string_view key, ReadElement read_element) {
    const Json* const value = reader.find(key);
    if (value == nullptr) {
        return;
    }
    const JsonPlace place = reader.place_of(key);
    if (!value->is_array()) {
        report_.add(place, "found " + shown(*value) + ", must be a list of objects");
        return;
    }
    ProgressCounter progress("taking in objects");
    for (std::size_t index = 0; index < value->size(); ++index) {
        progress.at(index, value->size());
        const JsonPlace at = place.element(index);
        if (ObjectReader::is_object((*value)[index], at, report_)) {
            read_element((*value)[index], at, index);
        }
    }
}

void SceneReader::named_materials(const ObjectReader& reader) {
    const Json* const value = reader.find("materials");
    const JsonPlace place = reader.place_of("materials");
    if (value == nullptr || !ObjectReader::is_object(*value, place, report_)) {
        return;
    }
    for (const auto& [name, members] : value->get_ref<const Json::object_t&>()) {
        materials_.emplace(name, scene_.materials.size());
        const JsonPlace at = place.member(name);
        Material& added = scene_.materials.emplace_back();
        if (ObjectReader::is_object(members, at, report_)) {
            added = material(members, at);
        }
        added.name = name;
    }
}

Material SceneReader::material(const Json& value, const JsonPlace& place) {
    const ObjectReader reader(value, place, report_);
    Material material;
    reader.colour("color", material.color, Need::optional);
    reader.colour("specular_color", material.specular_color, Need::optional);
    reader.colour("ka", material.ka, Need::optional);
    reader.colour("kd", material.kd, Need::optional);
    reader.colour("ks", material.ks, Need::optional);
    reader.colour("kr", material.kr, Need::optional);
    reader.colour("kt", material.kt, Need::optional);
    reader.number("shininess", material.shininess, Need::optional);
    reader.number("ior", material.ior, Need::optional);
    reader.nothing_but(
        {"color", "specular_color", "ka", "kd", "ks", "kr", "kt", "shininess", "ior"});
    return material;
}

void SceneReader::light(const Json& value, const JsonPlace& place, std::size_t index) {
    const ObjectReader reader(value, place, report_);
    Light& light = scene_.lights.emplace_back();
    light.name = "light" + std::to_string(index);
    reader.text("name", light.name, Need::optional);
    reader.colour("intensity", light.intensity, Need::optional);
    std::size_t type = 0;
    if (!reader.choice("type", kLightTypeWords, type, Need::required)) {
        return;  // which other keys it may have is not known
    }
    if (type == 0) {
        PointLight point;
        reader.point("position", point.position, Need::required);
        read_attenuation_json(reader, point.attenuation);
        light.kind = point;
        reader.nothing_but({"name", "type", "intensity", "position", "attenuation"});
    } else {
        DirectionalLight directional;
        reader.point("direction", directional.direction, Need::required);
        light.kind = directional;
        reader.nothing_but({"name", "type", "intensity", "direction"});
    }
}

void SceneReader::object(const Json& value, const JsonPlace& place, std::size_t index) {
    const ObjectReader reader(value, place, report_);
    Object object;
    std::size_t type = 0;
    const bool has_type = reader.choice("type", kShapeTypeWords, type, Need::required);
    object.name = std::string(kShapeTypeWords[type]) + std::to_string(index);
    reader.text("name", object.name, Need::optional);
    object.material = object_material(reader, object.name);
    object.transform = transform(reader);
    if (has_type) {
        object.shape = shape(reader, type);
    }
    scene_.objects.push_back(std::move(object));
}

Shape SceneReader::shape(const ObjectReader& reader, std::size_t type) {
    Words keys{"name", "type", "material", "transform"};
    const auto only = [&](std::initializer_list<std::string_view> own) {
        keys.insert(keys.end(), own);
        reader.nothing_but(keys);
    };
    if (type == 0) {
        Sphere sphere;
        reader.point("center", sphere.center, Need::required);
        reader.number("radius", sphere.radius, Need::required);
        only({"center", "radius"});
        return sphere;
    }
    if (type == 1) {
        Polygon polygon;
        reader.points("vertices", polygon.vertices, Need::required);
        reader.points("normals", polygon.normals, Need::optional);
        only({"vertices", "normals"});
        return polygon;
    }
    if (type == 2) {
        Cone cone;
        reader.point("base", cone.base, Need::required);
        reader.number("base_radius", cone.base_radius, Need::required);
        reader.point("apex", cone.apex, Need::required);
        reader.number("apex_radius", cone.apex_radius, Need::required);
        only({"base", "base_radius", "apex", "apex_radius"});
        return cone;
    }
    only({"file", "smooth"});
    return mesh(reader);
}

Mesh SceneReader::mesh(const ObjectReader& reader) {
    Mesh mesh;
    const bool has_file = reader.text("file", mesh.file, Need::required);
    reader.truth("smooth", mesh.smooth, Need::optional);
    if (!has_file) {
        return mesh;
    }
    try {
        Mesh loaded = load_obj(folder_ / mesh.file, report_.warnings);
        loaded.file = mesh.file;
        loaded.smooth = mesh.smooth;
        return loaded;
    } catch (const InputError& error) {
        const JsonPlace place = reader.place_of("file");
        for (const Mistake& mistake : error.mistakes()) {
            report_.add(place, mistake.message());
        }
    }
    return mesh;
}

std::size_t SceneReader::object_material(const ObjectReader& reader,
                                         const std::string& object_name) {
    constexpr std::string_view allowed = "the name of a material, or a material";
    const Json* const value = reader.need("material", allowed);
    if (value == nullptr) {
        return 0;
    }
    const JsonPlace place = reader.place_of("material");
    if (value->is_object()) {
        Material in_place = material(*value, place);
        in_place.name = object_name;
        in_place.in_place = true;
        scene_.materials.push_back(std::move(in_place));
        return scene_.materials.size() - 1;
    }
    if (!value->is_string()) {
        report_.add(place, "found " + shown(*value) + ", must be " + std::string(allowed));
        return 0;
    }
    const auto& name = value->get_ref<const std::string&>();
    const auto found = materials_.find(name);
    if (found != materials_.end()) {
        return found->second;
    }
    if (report_.is_full()) {
        return 0;
    }
    Words names;
    for (const auto& [known, index] : materials_) {
        names.push_back(known);
    }
    std::sort(names.begin(), names.end());
    report_.add(place, "there is no material " + shown(*value) + did_you_mean(name, names));
    return 0;
}

std::optional<Affine> SceneReader::transform(const ObjectReader& reader) {
    if (!reader.has("transform")) {
        return std::nullopt;
    }
    const Json& rows = *reader.find("transform");
    const JsonPlace place = reader.place_of("transform");
    if (!rows.is_array() || rows.size() != 4) {
        report_.add(place, "found " + shown(rows) + ", must be 4 rows of 4 numbers");
        return std::nullopt;
    }
    std::array<std::array<double, 4>, 4> matrix;
    bool all = true;
    for (std::size_t row = 0; row < 4; ++row) {
        all &= read_numbers(rows[row], place.element(row), 4, matrix[row].data(), report_);
    }
    if (!all) {
        return std::nullopt;
    }
    if (matrix[3] != std::array<double, 4>{0, 0, 0, 1}) {
        report_.add(place.element(3), "must be [0, 0, 0, 1]: only affine transforms are allowed");
    }
    return Affine{matrix[0], matrix[1], matrix[2]};
}

/// Whether one of the places lies at or below the other.
bool related(const std::string& a, const std::string& b) {
    const std::string& shorter = a.size() < b.size() ? a : b;
    const std::string& longer = a.size() < b.size() ? b : a;
    return longer.starts_with(shorter) &&
           (longer.size() == shorter.size() || longer[shorter.size()] == '/');
}

/// Adds what `validate` finds, except where a value was not read: it then judged a default.
void add_validation(const Scene& scene, JsonReport& report) {
    const std::size_t reported = report.mistakes.size();
    for (Mistake& mistake : validate(scene)) {
        const bool known =
            std::any_of(report.mistakes.begin(),
                        report.mistakes.begin() + static_cast<std::ptrdiff_t>(reported),
                        [&](const Mistake& other) { return related(mistake.place, other.place); });
        if (!known) {
            mistake.file = report.file;
            report.mistakes.push_back(std::move(mistake));
        }
    }
}

}  // namespace

Scene read_scene_json(const Json& document, const std::filesystem::path& folder,
                      JsonReport& report) {
    check_json_format(document, "raytree-scene", 1, 0, report);
    Scene scene = SceneReader(folder, report).read(document);
    add_validation(scene, report);
    return scene;
}

Scene read_scene_json(const std::string& text, const std::filesystem::path& file,
                      std::vector<std::string>& warnings) {
    JsonReport report;
    report.file = file.string();
    const Json document = parse_json(text, report.file);
    Scene scene = read_scene_json(document, file.parent_path(), report);
    if (!report.mistakes.empty()) {
        throw InputError(std::move(report.mistakes));
    }
    if (scene.name.empty()) {
        scene.name = file.stem().string();
    }
    warnings.insert(warnings.end(), report.warnings.begin(), report.warnings.end());
    return scene;
}

}  // namespace raytree
